// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The parametric image of a space curve on a surface (paper 3.4): cubic Hermite pieces, halved until they fit.
//!
//! The curve is cut where it is less than C1 and where its image jumps over a seam. At both ends of a piece the nearest
//! point of the surface is found and the curve's tangent is dropped onto the parameters; the cubic through both (eq. 3.13)
//! is the image if its points stand where they should at samples, else the piece is halved. Knots that are not needed
//! are then taken out.
//!
//! What is proven: where the curve lies on the surface (everywhere within the tolerance), the distance |C(t) - S(c(t))| of the
//! given curve C itself, which then stays the edge's curve. Elsewhere C is dropped along the surface's normal, the edge gets
//! a curve E of its own along the image, and |E(t) - S(c(t))| is proven; that c is C's image is checked at samples. How far C
//! keeps from its image, |C(t) - S(c(t))|, is proven apart from that.
//!
//! Over a hollow crease the nearest point jumps from one side to the other and has no continuous image. Where no piece of cubics
//! follows it, the piece with the jump may cross the crease: there the image's distance from C exceeds the least one by the
//! tolerance at most, or by a tenth, at samples. What keeps away from the surface is not known better than that.
#pragma once

#include "../nearest/face_nearest.h"
#include "../trimming/edge_curve.h"

#include <Geom2d_BSplineCurve.hxx>

namespace laminate_offset
{

//! The surface that curves are dropped onto.
struct ImageSurface
{
    const NearestSearch &search;
    Handle(Geom_Surface) surface;          //!< in local coordinates
    ParameterBox box;                      //!< of the search
    Handle(Geom_Surface) proof_surface;    //!< the surface itself, or a model of it with the same parameters
    const AnalyticSurface *form = nullptr; //!< of the proof surface; null: nothing can be proven
    double model_error = 0.0;              //!< how far the model may be from the surface [mm]
    double size = 0.0;                     //!< of the face [mm]
};

//! A space curve over a range of its parameter.
struct SpaceCurve
{
    Handle(Geom_Curve) curve;
    double first = 0.0;
    double last = 0.0;
};

//! The image of a part of a curve, between seams and borders.
struct ImagePiece
{
    Handle(Geom2d_Curve) pcurve; //!< with the parameters of the given curve
    Handle(Geom_Curve) curve;
    double first = 0.0;
    double last = 0.0;
    Deviation deviation;                  //!< of `curve` from the surface along the pcurve
    bool on_surface = true;               //!< `curve` is the given one
    double distance = 0.0;                //!< largest one seen between the given curve and its image [mm]
    std::optional<double> distance_bound; //!< proven bound of that distance [mm], where there is one
    bool bridged = false;                 //!< the image crosses a crease over which the nearest point jumps
};

//! The image of a curve on the surface's box, in order of its parameter; parts whose nearest points lie on the end of the
//! box are left out, all of it perhaps.
//! Refusal: EdgeToleranceNotReached, with its place (in local coordinates) where the image jumps.
Result<std::vector<ImagePiece>> image_of(const ImageSurface &on, const SpaceCurve &curve, double tolerance);

//! The image of a curve that need not lie on the surface, in one piece and with the curve's parameter: seen at samples to be
//! within `accuracy` [mm] of the nearest points. Nothing is proven.
//! \return null where that is not reached, or where a seam splits the image.
Handle(Geom2d_Curve) dropped_pcurve(const ImageSurface &on, const SpaceCurve &curve, double accuracy);

} // namespace laminate_offset
