// OBJ files as they come: polygons, negative indices, missing normals, and broken ones.

#include "mesh.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <stdexcept>

using namespace render;

namespace {

Mesh read(const std::string &text) {
    const TemporaryDirectory directory;
    const std::string file = directory / "mesh.obj";
    std::ofstream(file) << text;
    return readObj(file);
}

const std::string corners = "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n";

} // namespace

TEST_SUITE_BEGIN("meshes");

TEST_CASE("polygons are cut into triangles and get normals") {
    const Mesh mesh = read(corners + "f 1 2 3 4\n");
    REQUIRE(mesh.triangles.size() == 2);
    for (const auto &triangle : mesh.normals)
        for (const V3f &normal : triangle) CHECK((normal - V3f(0, 1, 0)).length() < 1e-6f);
}

TEST_CASE("missing normals are smooth across edges") {
    // A roof: its two sides face left and right, its ridge up.
    const Mesh mesh = read("v -1 0 1\nv -1 0 -1\nv 0 1 -1\nv 0 1 1\nv 1 0 -1\nv 1 0 1\n"
                           "f 1 4 3 2\nf 4 6 5 3\n");
    const float slope = std::sqrt(0.5f);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const V3f &p = mesh.positions[mesh.triangles[i][corner]];
            const V3f expected = p.x == 0 ? V3f(0, 1, 0) : V3f(p.x * slope, slope, 0);
            CHECK((mesh.normals[i][corner] - expected).length() < 1e-6f);
        }
    }
}

TEST_CASE("negative indices count from the end") {
    CHECK(read(corners + "f -4 -3 -2\n").triangles == read(corners + "f 1 2 3\n").triangles);
}

TEST_CASE("normals and texture coordinates are kept") {
    const Mesh mesh = read(corners + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 3 4\nf 1/1/1 2/2/1 3/3/1\n");
    CHECK((mesh.normals[0][2] - V3f(0, 0.6f, 0.8f)).length() < 1e-6f);
    CHECK(mesh.uvs[0][2] == V2f(1, 1));
}

TEST_CASE("broken files are refused") {
    CHECK_THROWS_AS(read("this is not a mesh\n"), std::runtime_error);
    CHECK_THROWS_AS(read(corners), std::runtime_error);
    CHECK_THROWS_AS(read(corners + "f 1 2 9\n"), std::runtime_error);
    CHECK_THROWS_AS(read(corners + "f -9 1 2\n"), std::runtime_error);
    CHECK_THROWS_AS(read(corners + "f 0 1 2\n"), std::runtime_error);
    CHECK_THROWS_AS(read("v 0 0 0\nv 1e99 0 0\nv 0 1 0\nf 1 2 3\n"), std::runtime_error);
    CHECK_THROWS_AS(readObj("/no/such/file.obj"), std::runtime_error);
    CHECK_THROWS_AS(readObj("/"), std::runtime_error);
}

TEST_CASE("a mesh stands on the floor") {
    Mesh mesh = read("v 10 5 3\nv 14 5 3\nv 10 8 3\nf 1 2 3\n");
    standOnFloor(mesh);
    CHECK(mesh.positions[0] == V3f(-1, 0, 0));
    CHECK(mesh.positions[1] == V3f(1, 0, 0));
    CHECK(mesh.positions[2] == V3f(-1, 1.5f, 0));
}

TEST_SUITE_END();
