/* pellicle @VERSION@: layered and thin-film reflectance and the classic shading models, as
 * eval / sample / pdf, for renderers. MIT OR Apache-2.0.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
 *
 * CONVENTIONS
 *
 * Frame. Directions are unit, point away from the surface and live in the local shading frame: +Z
 * is the shading normal, +X the tangent. wo goes to the viewer, wi to the light.
 *
 * Quantities. value = f(wo, wi) |wi.z|, RGB. pdf is per solid angle of wi. weight = value / pdf.
 * Lengths are nanometres. RGB is linear Rec.709, unless a film's description names another space; a
 * perfect mirror is (1, 1, 1) in all of them. A complex index is eta + i k, k >= 0, vacuum 1. Three
 * index values belong to 645, 525 and 445 nm: linear in 1 / lambda^2 between, constant outside.
 *
 * Sides. Without the flag TRANSMISSION, wi.z <= 0 or wo.z <= 0 gives 0: one-sided, the caller flips.
 * With it, z < 0 is the base's side and z = 0 gives 0. What is transmitted is radiance, which carries
 * (eta_o / eta_i)^2, unless the call asks for importance. Dirac lobes give value = pdf = 0; only
 * sample() returns them, with weight and pdf = 0.
 *
 * Data never fails. Finite inputs give finite, non-negative outputs (unclipped colours of films may
 * be negative). A direction within 1e-3 of unit length is accepted; unless it is unit to 5e-7 it is normalised first,
 * so that outputs are unit to 1e-6 and evaluations agree with samples. Any other direction, NaN and infinity
 * give 0 for that element and leave its neighbours alone. A varying parameter's
 * finite value outside its declared range is clamped to it; NaN or infinity there gives 0 for that
 * element. In the calls of a film, cosines are clamped to [1e-9, 1] and thicknesses to the declared
 * range, infinities too, and NaN gives 0. A varying parameter that a call does not give has its value
 * in `params`; without one there, it has the model's default, clamped to the declared range. Nothing
 * else is clamped.
 *
 * Pointers and counts can fail. Every function checks every pointer for NULL. On failure a status
 * other than PELLICLE_OK is returned, outputs are untouched, and pellicle_last_error() says which
 * argument was wrong, its value, and what is allowed. Every array may lie at any alignment.
 *
 * Threads. Every function may be called from any thread. Handles are immutable and
 * reference-counted: share them freely. Nothing starts threads, locks, logs, calls back or reads the
 * environment; the only state of the process is each thread's last error. Only these allocate: create();
 * pellicle_name(); pellicle_film_reference() and pellicle_film_spectrum(); what evaluates a film whose plan's method
 * is "reference"; and a failing call, for its message. A defect of pellicle is reported as PELLICLE_INTERNAL, and
 * Rust's line about it may appear on the standard error stream.
 *
 * Stack. Every call, create() too, needs at most 32 KiB of stack; reporting a defect may need more.
 *
 * Floating point. Results do not depend on the rounding that the host has set, and unmasked traps do not fire: a
 * call that finds another rounding than to nearest, or unmasked traps, sets the default and restores what was there.
 * That takes 6 to 8 ns for another rounding and 40 to 60 ns for traps. Where nothing differs, a single call takes half
 * a nanosecond longer, every other call 5 (Zen 4). One exception, on x86-64: single calls see traps that are unmasked
 * in both units, as by feenableexcept(), or that were unmasked in MXCSR when their film or BSDF was created; to unmask
 * them in MXCSR alone later is not supported. Flush-to-zero and denormals-are-zero stay as they are, and results are
 * right under both. Flags of exceptions may be raised; none is raised where traps are unmasked.
 *
 * Batches. Elements are evaluated side by side with the widest of SSE2, AVX2 and AVX-512, or NEON, that
 * the processor has, to the same bits as single calls. Components whose elements lie side by side are
 * the fastest, then whole packed elements.
 *
 * Growth. Structs grow by appending, and zero means default: zero-initialise them and state their
 * size. The size of a struct that is passed alone stands beside it in the call; that of PellicleCall in
 * its first field; that of PellicleMedium and PellicleLayer in the description that points to them.
 * A shorter struct of an older caller is accepted; a longer one is accepted if what this build does not
 * know is zero, else UNSUPPORTED. Outputs are written up to the smaller size. A size that no version can
 * have (0, above 65,536, or no multiple of the struct's alignment) is INVALID_ARGUMENT. Structs that say
 * "Frozen" do not grow.
 *
 * EXAMPLE
 *
 *   PellicleMedium glass = {0}, water = {0};
 *   glass.name = "BK7";
 *   water.name = "water";
 *   PellicleLayer layer = {&water, 0.0f, 500.0f};               // its thickness comes with every call
 *   PellicleFilmDesc desc = {sizeof glass, sizeof layer};       // the sizes of this header's structs
 *   desc.layers = &layer;
 *   desc.layer_count = 1;
 *   desc.base = &glass;
 *   PellicleFilm *film;
 *   if (pellicle_film_create(&desc, sizeof desc, &film) != PELLICLE_OK) puts(pellicle_last_error());
 *   else {
 *       float rgb[3];
 *       pellicle_film_reflectance(film, 0.8f, 320.0f, rgb);     // cosine of incidence, nm
 *       pellicle_film_release(film);
 *   }
 */
