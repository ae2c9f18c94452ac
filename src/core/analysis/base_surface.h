// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The base surface restricted to the parameter box of its loops: evaluation, knots, unit normals.
#pragma once

#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <optional>
#include <vector>

namespace laminate_offset
{

//! A parameter line across which the base surface is only C^continuity.
struct SmoothnessBreak
{
    double parameter = 0.0;
    int continuity = 0;
};

//! A point so near to an axis of revolution [mm] is meant to lie on it: files have rounded it.
inline constexpr double meant_on_axis = 1e-7;

//! How far the spline that stands for the base may be from the base itself: proven bounds at equal
//! parameters, rounding included. All zero where the spline is the base.
struct ModelError
{
    double point = 0.0;     //!< |S - S*| [mm]
    double normal = 0.0;    //!< |N - N*|
    double curvature = 0.0; //!< of the principal curvatures [1/mm]
    //! Further, a factor: k lies between k* / (1 + curvature_ratio) - curvature and
    //! k* (1 + curvature_ratio) + curvature for k*, k > 0, turned around for k* < 0. A ratio keeps the sign.
    double curvature_ratio = 0.0;

    //! What it adds to the error of S + distance * N [mm].
    [[nodiscard]] double of_offset(double distance) const;
};

//! A narrow strip of a surface whose curvature depends on one parameter only, in coordinates of its own. On its
//! middle line it has the surface's curvatures.
struct CurvatureStrip
{
    TensorSpline spline;
    bool along_u = false;  //!< u (else v) is the parameter, with the surface's own values
    double middle = 0.0;   //!< the other parameter on the middle line
    double width = 1.0;    //!< of the strip in the other parameter
    double fineness = 1.0; //!< lengths across the strip, against those of a surface as wide as it is long
};

//! What a model has to be good for.
struct ModelDemand
{
    double distance = 0.0;  //!< of the offset [mm]
    double tolerance = 0.0; //!< of the offset [mm]; a model takes a small part of it
};

//! Evaluates the base surface in one of two ways: as a tensor-product spline where the surface is one in the
//! same parameters or has a model (swept_model.h), else through Geom_Surface.
class BaseSurface
{
public:
    //! \param box part of the surface that has to be evaluated; a spline base is cut down to it.
    //! \param demand empty: only a surface that is a spline itself becomes one, and it stays as it is.
    BaseSurface(const Handle(Geom_Surface) & surface, const ParameterBox &box,
                const std::optional<ModelDemand> &demand = std::nullopt);

    //! From here on another spline, within `error` of this one, rounding() included, and over the same box, stands for the base.
    void adopt_model(TensorSpline model, const ModelError &error);

    [[nodiscard]] const ParameterBox &box() const { return m_box; }
    //! The base as a spline in the same parameters, or a spline within model_error() of it, if there is one.
    [[nodiscard]] const std::optional<TensorSpline> &spline() const { return m_spline; }
    [[nodiscard]] const ModelError &model_error() const { return m_model_error; }
    //! How far the poles of spline() may be from those of the base, in units of rounding of their largest coordinates, where
    //! that has consequences for its normals: certify() takes it.
    [[nodiscard]] double rounding() const { return m_rounding; }
    //! Where there is one, curvatures are those of the strip, and model_error() says how near they are.
    [[nodiscard]] const std::optional<CurvatureStrip> &strip() const { return m_strip; }
    //! Interior breaks in increasing order.
    [[nodiscard]] const std::vector<SmoothnessBreak> &breaks_u() const { return m_breaks_u; }
    [[nodiscard]] const std::vector<SmoothnessBreak> &breaks_v() const { return m_breaks_v; }
    //! The breaks' parameters between the ends of the box.
    [[nodiscard]] std::vector<double> interval_ends_u() const;
    [[nodiscard]] std::vector<double> interval_ends_v() const;

    //! Jets on the grid us x vs (see TensorSpline::jets).
    [[nodiscard]] std::vector<SurfaceJet> jets(const std::vector<double> &us, const std::vector<double> &vs,
                                               int order) const;

    //! S_u x S_v scaled to length 1 at a jet's place. At a singular place (a pole, a collapsed side) the
    //! limit of the normal from inside the box. Nothing where that does not exist either.
    [[nodiscard]] std::optional<Eigen::Vector3d> unit_normal(const SurfaceJet &jet, double u, double v) const;

    //! S + distance * N on the grid; empty with `singular` set to the place where N does not exist.
    [[nodiscard]] std::vector<Eigen::Vector3d> offset_grid(const std::vector<double> &us, const std::vector<double> &vs,
                                                           double distance, std::optional<gp_Pnt2d> &singular) const;

private:
    [[nodiscard]] std::optional<Eigen::Vector3d> limit_normal(double u, double v) const;

    Handle(Geom_Surface) m_surface;
    ParameterBox m_box;
    std::optional<TensorSpline> m_spline;
    ModelError m_model_error;
    double m_rounding = 0.0;
    std::optional<CurvatureStrip> m_strip;
    std::vector<SmoothnessBreak> m_breaks_u;
    std::vector<SmoothnessBreak> m_breaks_v;
};

//! The interior knots and how smooth a spline of general position is there.
std::vector<SmoothnessBreak> spline_breaks(const KnotVector &kv);

//! The box that the fit covers: the loops' box with a small margin, kept inside the surface's own
//! domain where the surface has ends.
ParameterBox fit_box(const InputFace &input);

} // namespace laminate_offset
