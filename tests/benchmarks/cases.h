// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The base faces that are measured: generated ones and those of ../shared/data.
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include <string>
#include <vector>

namespace benchmark
{

struct BaseFace
{
    std::string name; //!< "panel 8x8", "file.step#3" (faces from 1)
    TopoDS_Face face;
    int poles = 0;                  //!< of the base surface, 0 where it has none
    double diagonal = 0.0;          //!< of the bounding box [mm]
    bool free_form = true;          //!< no plane, cylinder, cone, sphere or torus
    double lowest_curvature = 0.0;  //!< least and largest principal curvature seen on a dense grid inside the
    double highest_curvature = 0.0; //!< loops, positive where the surface bends towards its outward normal

    //! Judged by the dense grid alone: 1 - d k > 0 everywhere.
    [[nodiscard]] bool feasible(double distance) const
    {
        return 1.0 - distance * lowest_curvature > 0.0 && 1.0 - distance * highest_curvature > 0.0;
    }
};

//! A face with the figures above.
BaseFace describe(const std::string &name, const TopoDS_Face &face);

//! The surface below rectangular trims.
Handle(Geom_Surface) unwrapped(const Handle(Geom_Surface) & surface);

//! The generated faces of the comparison with OpenCASCADE.
std::vector<BaseFace> generated_faces();

//! One generated face by its name. \throw std::out_of_range for an unknown one.
BaseFace generated_face(const std::string &name);

//! Every face of the real models, empty where ../shared/data is absent. Every stride-th one only.
std::vector<BaseFace> real_faces(bool free_form_only, int stride = 1);

} // namespace benchmark
