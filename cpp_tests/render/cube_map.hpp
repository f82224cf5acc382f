// Six images of a cube's faces, as light from infinitely far away.
#pragma once

#include "lat_long.hpp"

#include <array>
#include <string>

namespace render {

/// Faces in the order px, nx, py, ny, pz, nz, each `size` x `size` texels with rows from the top, as
/// they look from inside the cube. A cube map's axes are left-handed ("The OpenGL Graphics System",
/// version 4.6, table 8.19) and the world's are right-handed, so z changes its sign: pz is ahead of
/// the camera (-z), px on its right (+x), py above (+y).
struct CubeMap {
    int size;
    std::array<std::vector<Rgb>, 6> faces;
};

/// The six images PREFIXpx.*, PREFIXnx.* and so on, of any format that OpenImageIO reads, converted to
/// linear colours. A prefix that ends in "/" is a directory. Throws std::runtime_error if a face is
/// missing, there twice, not square or of another size than the first.
CubeMap readCubeMap(const std::string &prefix);

/// PREFIXpx.exr and so on. Throws std::runtime_error.
void writeCubeMap(const CubeMap &map, const std::string &prefix);

/// A face and the place on it, in [0, 1] from its left and upper edges.
struct CubePoint {
    int face;
    V2f st;
};
CubePoint cubePoint(const V3f &direction);

/// The direction of a point of the cube, unit length.
V3f cubeDirection(const CubePoint &point);

/// A map with the radiance's value at each texel's centre.
template <typename Radiance>
CubeMap drawCube(int size, const Radiance &radiance) {
    CubeMap map{size, {}};
    for (int face = 0; face < 6; ++face) {
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column)
                map.faces[face].push_back(radiance(cubeDirection(
                    {face, V2f(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f) /
                               static_cast<float>(size)})));
    }
    return map;
}

/// The same light as a latitude-longitude map with texels half as wide, bilinear within each face.
LatLongMap unrolled(const CubeMap &map);

} // namespace render
