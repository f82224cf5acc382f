// The colours that thin films are known for, measured in rendered pictures. Published tables are
// judged by eye and rounded to 10 nm, so a colour has to appear within 10 nm of its thickness there.

#include "hue.hpp"
#include "render.hpp"
#include "stacks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

using namespace render;

namespace {

constexpr float published = 10; ///< nm, the tolerance of published thicknesses

/// Seen at normal incidence in white light of radiance 1.
class Patch {
public:
    Patch(const Stack &stack, float thicknessMax) : film_(stack.film(thicknessMax).create()) {}

    Rgb at(float thickness) const {
        const auto material = std::make_shared<Material>(
            pellicle::BsdfBuilder("film").film(film_).set("thickness_nm", thickness));
        World world;
        world.add(Sphere{V3f(0), 1}, material);
        world.commit();
        RenderSettings settings;
        settings.width = settings.height = 1;
        settings.samplesPerPixel = 4;
        settings.threads = 1;
        // Half a degree wide: cosines above 0.998.
        const Picture picture = renderPicture(world, Environment::constant(Rgb(1)),
                                              Camera(V3f(0, 0, 6), V3f(0), 0.5f), settings);
        return picture.pixels[0].radiance;
    }

    Perceived perceivedAt(float thickness) const { return perceived(at(thickness)); }

private:
    pellicle::Film film_;
};

struct Published {
    float thickness; ///< nm
    HueRange hue;
};

/// Every published hue appears within the tolerance.
void checkHues(const Patch &patch, const std::vector<Published> &table) {
    for (const Published &entry : table) {
        const double hue = patch.perceivedAt(entry.thickness).hue;
        float nearest = 1000;
        for (float away = -std::min(published, entry.thickness); away <= published; away += 1) {
            if (!entry.hue.contains(patch.perceivedAt(entry.thickness + away).hue)) continue;
            if (std::fabs(away) < std::fabs(nearest)) nearest = away;
        }
        MESSAGE(entry.thickness, " nm: hue ", hue, "; ", std::string(entry.hue.name), " at ", nearest,
                " nm from there");
        CHECK(std::fabs(nearest) <= published);
    }
}

/// Degrees by which the hue turns from one thickness to the next; as interference colours do, from red
/// through violet to blue and green, if negative.
double turn(const Patch &patch, float from, float to) {
    const double difference = patch.perceivedAt(to).hue - patch.perceivedAt(from).hue;
    return difference - 360 * std::round(difference / 360);
}

} // namespace

TEST_SUITE_BEGIN("film_claims");

// The chart of every clean room, after W. Pliskin and E. Conrad, "Nondestructive Determination of
// Thickness and Refractive Index of Transparent Films", IBM Journal 8, 1964: perpendicular view in
// fluorescent light. As printed by the University of Illinois, fabweb.ece.illinois.edu/gt/gt/gt7.aspx.
TEST_CASE("silicon dioxide on silicon has the colours of the published chart") {
    const Patch patch(oxidisedSilicon(), 520);
    checkHues(patch, {
                         {50, hues::orange}, // tan
                         {70, hues::orange}, // brown
                         {100, hues::violet}, // dark violet to red violet
                         {120, hues::blue}, // royal blue
                         {150, hues::blue}, // light blue to metallic blue
                         {200, hues::gold}, // light gold or yellow
                         {220, hues::gold}, // gold with slight yellow-orange
                         {250, hues::orange}, // orange to melon
                         {270, hues::redViolet},
                         {300, hues::blueViolet}, // blue to violet-blue
                         {310, hues::blue},
                         {320, hues::blueGreen}, // blue to blue-green
                         {340, hues::green}, // light green
                         {350, hues::green}, // green to yellow-green
                         {360, hues::yellowGreen},
                         {370, hues::yellowGreen}, // green-yellow
                         {390, hues::yellow},
                         {410, hues::orange}, // light orange
                         {420, hues::pink}, // carnation pink
                         {440, hues::redViolet}, // violet-red
                         {460, hues::redViolet},
                         {470, hues::violet},
                         {480, hues::blueViolet},
                         {490, hues::blue},
                         {500, hues::blueGreen},
                     });
    // "Metallic" at 170 nm: the palest and brightest of the chart's first turn.
    CHECK(patch.perceivedAt(170).chroma < 12);
    CHECK(patch.perceivedAt(170).lightness > patch.perceivedAt(100).lightness + 20);
    // Brown is darker than tan, and dark violet darkest.
    CHECK(patch.perceivedAt(70).lightness < patch.perceivedAt(50).lightness);
    CHECK(patch.perceivedAt(100).lightness < patch.perceivedAt(70).lightness);
}

TEST_CASE("silicon dioxide's colours follow one another in one order") {
    const Patch patch(oxidisedSilicon(), 520);
    double turned = 0;
    for (float thickness = 60; thickness < 500; thickness += 10) {
        const double step = turn(patch, thickness, thickness + 10);
        CAPTURE(thickness);
        CHECK(step < 0);
        turned += step;
    }
    MESSAGE("from 60 to 500 nm the hue turns by ", turned, " degrees");
    // The chart begins with brown and comes to orange again at 250 and at 410 nm, which is two turns;
    // from there to blue-green at 500 nm it is 210 degrees more. Names are good to 45 degrees at
    // either end.
    CHECK(std::fabs(turned + 720 + 210) < 90);
}

// r is the difference of two equal and opposite reflections, which cancel; to first order in the
// thickness R = (pi d (n^2 - 1) / lambda)^2, n = 1.333.
TEST_CASE("a soap film is black where it is thinnest") {
    const Patch patch(soap(), 800);
    CHECK(maxComponent(patch.at(0)) < 1e-6f);
    const auto thin = [](float thickness, float lambda) {
        const float r = pi * thickness * (1.333f * 1.333f - 1) / lambda;
        return r * r;
    };
    float brightest = 0;
    for (float thickness = 0; thickness <= 200; thickness += 5)
        brightest = std::max(brightest, luminance(patch.at(thickness)));
    // The "common black film" is up to 30 nm thick (K. Mysels, K. Shinoda and S. Frankel, "Soap Films",
    // 1959).
    for (const float thickness : {5.0f, 10.0f, 20.0f, 30.0f}) {
        const float y = luminance(patch.at(thickness));
        MESSAGE(thickness, " nm: ", y, ", brightest ", brightest);
        CHECK(y < brightest / 4);
        if (thickness > 10) continue;
        // The wavelengths that make up luminance; 2e-3 is the film's tolerance.
        CHECK(y > thin(thickness, 620) - 2e-3f);
        CHECK(y < thin(thickness, 490) + 2e-3f);
    }
}

// The order with growing thickness: black, white, then yellow, orange, red, violet, blue, green, and
// yellow, orange-red, violet once more (K. Nassau, "Colour", Encyclopaedia Britannica). Where each
// begins follows from the film's index.
TEST_CASE("a soap film shows Newton's colours in their order") {
    const Patch patch(soap(), 800);
    const Perceived white = patch.perceivedAt(100);
    CHECK(white.chroma < 5);
    CHECK(white.lightness > 25);
    const std::vector<HueRange> order{hues::yellow, hues::orange, hues::redViolet, hues::blueViolet, hues::blue,
                                      hues::blueGreen, hues::green, hues::yellow, hues::orange,
                                      hues::redViolet};
    std::size_t next = 0;
    for (float thickness = 110; thickness <= 420 && next < order.size(); thickness += 2) {
        if (!order[next].contains(patch.perceivedAt(thickness).hue)) continue;
        MESSAGE(std::string(order[next].name), " from ", thickness, " nm");
        ++next;
    }
    CHECK(next == order.size());
    for (float thickness = 110; thickness < 400; thickness += 10) {
        CAPTURE(thickness);
        CHECK(turn(patch, thickness, thickness + 10) < 0);
    }
}

// Thickness from the voltage, about 2 nm per volt: nokit.org/chemistry/experiments/
// titanium-anodizing.html. Real anodic oxide is less dense than the rutile assumed here.
TEST_CASE("anodised titanium is gold, then violet, then blue") {
    const Patch patch(anodisedTitanium(), 200);
    CHECK(patch.perceivedAt(0).chroma < 6); // bare metal is grey
    checkHues(patch, {
                         {8, hues::gold},
                         {16, hues::gold},
                         {24, hues::violet},
                         {32, hues::violet},
                         {40, hues::blue},
                         {50, hues::blue},
                         {60, hues::blue},
                         {70, hues::blueGreen},
                         {80, hues::yellowGreen},
                         {90, hues::yellow}, // straw
                         {110, hues::pink},
                     });
    CHECK(patch.perceivedAt(16).chroma > 25);
    CHECK(patch.perceivedAt(40).chroma > 40);
}

// The colours of tempering, in the order of temperature and so of thickness: faint yellow, straw,
// brown, purple, dark blue, light blue, grey-blue (Wikipedia, "Tempering (metallurgy)").
TEST_CASE("tempered steel turns from straw through brown and purple to blue") {
    const Patch patch(temperedSteel(), 120);
    CHECK(patch.perceivedAt(0).chroma < 4);
    double darkest = 100;
    float darkestAt = 0;
    std::size_t next = 0;
    const std::vector<HueRange> order{hues::yellow, hues::orange, hues::redViolet, hues::blueViolet, hues::blue,
                                      hues::blueGreen};
    for (float thickness = 5; thickness <= 100; thickness += 1) {
        const Perceived colour = patch.perceivedAt(thickness);
        if (colour.lightness < darkest) darkest = colour.lightness, darkestAt = thickness;
        if (next == order.size() || colour.chroma < 4 || !order[next].contains(colour.hue)) continue;
        MESSAGE(std::string(order[next].name), " from ", thickness, " nm");
        ++next;
    }
    CHECK(next == order.size());
    // Darkest between purple and blue, and pale again at the end.
    const Perceived darkestColour = patch.perceivedAt(darkestAt);
    CHECK((hues::violet.contains(darkestColour.hue) || hues::blueViolet.contains(darkestColour.hue)));
    CHECK(patch.perceivedAt(90).lightness > 65);
}

// R = ((1 - n^2 / n_glass)^2 / (1 + n^2 / n_glass)^2) at a quarter wave of 550 nm: 1.25 %, against 4.2 % of
// bare glass. What is left is purple: least is reflected in the green.
TEST_CASE("a quarter wave of magnesium fluoride takes most of glass's reflection away") {
    const Patch patch(coatedGlass(), 200);
    const Rgb bare = patch.at(0), coated = patch.at(100);
    CHECK(bare.y == doctest::Approx(0.0424).epsilon(0.05).scale(0));
    CHECK(coated.y == doctest::Approx(0.0125).epsilon(0.1).scale(0));
    CHECK(coated.y < coated.x);
    CHECK(coated.y < coated.z);
    const Perceived left = perceived(coated);
    CHECK((hues::violet.contains(left.hue) || hues::blueViolet.contains(left.hue)));
}

TEST_SUITE_END();
