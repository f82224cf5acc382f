// Describes a soap film in WebAssembly's memory, and compares its reflectance with Airy's formula.
// Usage: node wasm.mjs <pellicle.wasm>
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {});
const pellicle = instance.exports;
const memory = () => new DataView(pellicle.memory.buffer);
const text = (address) => {
    const bytes = new Uint8Array(pellicle.memory.buffer, address);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
};

// A page of its own for what C would keep on its stack. Pointers and size_t have 4 bytes here.
let next = pellicle.memory.grow(1) * 65536;
const reserve = (bytes) => {
    const address = next;
    next += (bytes + 15) & ~15;
    return address;
};
const check = (status, call) => {
    if (status !== 0) throw new Error(`${call}: ${text(pellicle.pellicle_last_error())}`);
};

// PellicleMedium: name, eta[3], k[3], ...; zeros are the default.
const MEDIUM_SIZE = 44;
const medium = (eta) => {
    const address = reserve(MEDIUM_SIZE);
    for (let channel = 0; channel < 3; ++channel) memory().setFloat32(address + 4 + 4 * channel, eta, true);
    return address;
};

// Magnesium fluoride's index on glass: 300 nm fixed.
const [outside, coating, glass] = [1.0, 1.38, 1.52];
const thickness = 300;
const layer = reserve(12);
memory().setUint32(layer, medium(coating), true);
memory().setFloat32(layer + 4, thickness, true);
memory().setFloat32(layer + 8, thickness, true);
const DESC_SIZE = 52;
const desc = reserve(DESC_SIZE);
for (const [offset, number] of [[0, MEDIUM_SIZE], [4, 12], [12, layer], [16, 1], [20, medium(glass)]])
    memory().setUint32(desc + offset, number, true);
const handle = reserve(4);
check(pellicle.pellicle_film_create(desc, DESC_SIZE, handle), "pellicle_film_create");
const film = memory().getUint32(handle, true);

// Airy's reflectance of one layer, normal incidence.
const airy = (lambda) => {
    const r1 = (outside - coating) / (outside + coating);
    const r2 = (coating - glass) / (coating + glass);
    const cosine = Math.cos((4 * Math.PI * coating * thickness) / lambda);
    return (r1 * r1 + r2 * r2 + 2 * r1 * r2 * cosine) / (1 + r1 * r1 * r2 * r2 + 2 * r1 * r2 * cosine);
};
let worst = 0;
for (let lambda = 400; lambda <= 700; lambda += 10) {
    const [wavelength, reflectance] = [reserve(4), reserve(4)];
    memory().setFloat32(wavelength, lambda, true);
    check(pellicle.pellicle_film_spectrum(film, 1, thickness, wavelength, 1, reflectance), "pellicle_film_spectrum");
    worst = Math.max(worst, Math.abs(memory().getFloat32(reflectance, true) - airy(lambda)));
}
console.log(`greatest difference from Airy's formula, 400 to 700 nm: ${worst}`);

// The compiled film holds its tolerance, 2e-3, against its own reference.
const [rgb, reference] = [reserve(12), reserve(12)];
check(pellicle.pellicle_film_reflectance(film, 1, thickness, rgb), "pellicle_film_reflectance");
check(pellicle.pellicle_film_reference(film, 1, thickness, reference), "pellicle_film_reference");
const channels = (address) => [0, 4, 8].map((offset) => memory().getFloat32(address + offset, true));
const error = Math.max(...channels(rgb).map((value, i) => Math.abs(value - channels(reference)[i])));
console.log(`reflectance ${channels(rgb)}, reference ${channels(reference)}`);
pellicle.pellicle_film_release(film);

// A failure comes with its message.
memory().setUint32(desc + 16, 65, true);
const status = pellicle.pellicle_film_create(desc, DESC_SIZE, handle);
console.log(`65 layers: ${status}, ${text(pellicle.pellicle_last_error())}`);
if (!(worst < 1e-5 && error <= 2e-3 && status !== 0 && rgb > 0)) process.exit(1);
