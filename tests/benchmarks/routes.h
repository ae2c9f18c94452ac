// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The two ways to an offset that are compared, and what is measured of each.
#pragma once

#include <laminate_offset/base/options.h>

#include <TopoDS_Face.hxx>

#include <array>

namespace benchmark
{

struct Task
{
    double distance = 0.0;  //!< [mm] along the outward normal
    double tolerance = 0.0; //!< [mm]
    int runs = 3;           //!< timed runs; slow ones are repeated less
    int grid = 100;         //!< samples in each direction for the independent error
    laminate_offset::Method method = laminate_offset::Method::SameParameter; //!< ours
};

//! Plain bytes, so that it passes through a pipe.
struct Outcome
{
    bool made = false;
    bool valid = false;     //!< ours: BRepCheck_Analyzer
    bool has_where = false; //!< a refusal with its place
    bool certified = false;
    bool fold_confirmed = false; //!< a refusal for curvature whose place lies inside the loops and does fold there
    char status[40] = "";
    char message[240] = "";
    int poles_u = 0, poles_v = 0, degree_u = 0, degree_v = 0;
    double ms = 0.0;
    double cpu_ms = 0.0;            //!< of all threads together; other work on the machine hardly counts
    double bound = 0.0;             //!< certified_error [mm]
    double sampled = 0.0;           //!< largest deviation from S + d N inside the loops [mm]: at equal parameters, or,
                                    //!< where that misses the tolerance, the distance of S + d N to the surface
    std::array<double, 8> stages{}; //!< ours: ms by Stage

    [[nodiscard]] int poles() const { return poles_u * poles_v; }
};

//! laminate_offset::offset_face, certificate and trimming included.
Outcome run_ours(const TopoDS_Face &face, const Task &task);

//! BRepOffsetAPI_MakeOffsetShape by join, then GeomConvert_ApproxSurface (C1, degree 14) of its surface.
Outcome run_occt(const TopoDS_Face &face, const Task &task);

} // namespace benchmark
