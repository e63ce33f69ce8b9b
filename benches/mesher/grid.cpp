// A million points and unit normals of a bicubic rational surface of 50 x 50, and two million
// triangles, by OpenCASCADE: what the bench `surface_grid_mesh` does here. With Debian's packages
// libocct-foundation-dev and libocct-modeling-data-dev:
//
//     g++ -O2 -w -I/usr/include/opencascade grid.cpp -o grid -lTKG3d -lTKGeomBase -lTKMath -lTKernel && ./grid
#include <Geom_BSplineSurface.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Dir.hxx>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

int main() {
    const int n_net = 50, n_grid = 1000, n_knots = n_net - 2;
    TColgp_Array2OfPnt points(1, n_net, 1, n_net);
    TColStd_Array2OfReal weights(1, n_net, 1, n_net);
    for (int i = 1; i <= n_net; i++) {
        for (int j = 1; j <= n_net; j++) {
            points(i, j) = gp_Pnt(i, j, 2 * std::sin(0.4 * i) * std::cos(0.3 * j));
            weights(i, j) = 1 + 0.1 * std::sin(i + j);
        }
    }
    TColStd_Array1OfReal knots(1, n_knots);
    TColStd_Array1OfInteger times(1, n_knots);
    for (int i = 1; i <= n_knots; i++) {
        knots(i) = (i - 1.0) / (n_knots - 1);
        times(i) = i == 1 || i == n_knots ? 4 : 1;
    }
    Handle(Geom_BSplineSurface) surface =
        new Geom_BSplineSurface(points, weights, knots, knots, times, times, 3, 3);
    for (int round = 0; round < 9; round++) {
        auto start = std::chrono::steady_clock::now();
        // The adaptor keeps the patch at hand, which asking the surface itself does not.
        GeomAdaptor_Surface adaptor(surface);
        std::vector<gp_Pnt> vertices(n_grid * n_grid);
        std::vector<gp_Dir> normals(n_grid * n_grid);
        std::vector<std::array<int, 3>> triangles;
        triangles.reserve(2 * (n_grid - 1) * (n_grid - 1));
        for (int i = 0; i < n_grid; i++) {
            for (int j = 0; j < n_grid; j++) {
                gp_Vec along_u, along_v;
                const int vertex = i * n_grid + j;
                adaptor.D1(i / (n_grid - 1.0), j / (n_grid - 1.0), vertices[vertex], along_u, along_v);
                normals[vertex] = gp_Dir(along_u.Crossed(along_v));
            }
        }
        for (int i = 0; i + 1 < n_grid; i++) {
            for (int j = 0; j + 1 < n_grid; j++) {
                const int a = i * n_grid + j, b = a + n_grid;
                triangles.push_back({a, b, b + 1});
                triangles.push_back({a, b + 1, a + 1});
            }
        }
        std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        std::printf("%.1f ms, %zu triangles\n", time.count(), triangles.size());
    }
}
