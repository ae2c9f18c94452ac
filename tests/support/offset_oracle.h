// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! An independent judge of an offset face: it measures with OpenCASCADE alone and shares no code with the engine.
//!
//! The exact offset of a point of the base is S(u,v) + d N(u,v), where N is the unit normal of the face, its
//! orientation included. All figures below are in mm and are the largest found. Every distance to a surface or
//! curve is that of a point found on it, so it never understates the true distance.
#pragma once

#include <TopoDS_Face.hxx>

#include <gtest/gtest.h>

#include <string>

namespace test_support
{

struct OracleOptions
{
    int grid = 200;        //!< points in each direction over the base's parameter box; those inside the loops count
    int edge_points = 200; //!< points along each edge
};

struct OracleReport
{
    int points = 0;              //!< grid points inside the base face that were compared
    int undefined_normals = 0;   //!< grid points inside the base face without a normal
    double parametric_error = 0; //!< | R(u,v) - exact(u,v) | at equal parameters (same-parameter results only)
    double surface_error = 0;    //!< exact offset points to the result's surface
    double converse_error = 0;   //!< | distance of the result's points to the base - |d| |
    double least_cosine = 1;     //!< between the normals of base and result at the same place
    int misplaced = 0;           //!< grid points inside the base face whose offset lies outside the result's loops

    int compared_edges = 0;         //!< edges with a curve that were compared
    double edge_error = 0;          //!< exact offset of the base's edges to the result's edge curves
    double edge_converse = 0;       //!< result's edge curves to the exact offset of the base's edges
    double vertex_error = 0;        //!< result's vertices to the exact offset of the base's edge ends
    double pcurve_error = 0;        //!< result's edge curves to their pcurves at equal parameters
    double untold_pcurve_error = 0; //!< the part of it that an edge's own tolerance does not admit

    int base_loops = 0, loops = 0;
    int base_edges = 0, edges = 0;
    bool valid = false;           //!< BRepCheck_Analyzer
    bool same_parameter = true;   //!< flags SameParameter and SameRange of every edge
    bool orientation_kept = true; //!< of the face and of every edge in its loop
    double largest_tolerance = 0; //!< of the result's edges and vertices
    double base_largest_tolerance = 0;
};

//! Measures result against the exact offset of base at the signed distance [mm].
//! Edges are compared in the order in which the faces store them.
OracleReport measure_offset(const TopoDS_Face &base, const TopoDS_Face &result, double distance,
                            const OracleOptions &options = {});

//! Whether all that was measured is right within tolerance [mm]; says everything that is not.
testing::AssertionResult confirms(const OracleReport &report, double tolerance);

//! Least factor 1 - d k over both principal curvatures k on a dense grid inside the loops. The offset at d is
//! regular where it is positive and folds where it is negative.
double least_curvature_factor(const TopoDS_Face &face, double distance, int grid = 200);

//! All figures in one line.
std::string to_text(const OracleReport &report);

} // namespace test_support
