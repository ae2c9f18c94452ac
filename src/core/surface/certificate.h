// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The proof: an upper bound of |O(u,v) - (S(u,v) + d N(u,v))| over whole regions of parameters.
//!
//! On each rectangle between the merged knots, w = O - S is a (rational) polynomial. The bound follows
//! from Bernstein coefficients of a = w.w - d^2, b = w.T1 and c = w.T2, where T1, T2 are constant
//! combinations of S_u, S_v that are orthonormal at the rectangle's centre:
//! the tangential part is |w_t|^2 <= (max b^2 + max c^2) / lambda_min of their Gram matrix, the normal
//! part lies between sqrt(d^2 + min a - |w_t|^2) and sqrt(d^2 + max a), its sign is read at the centre and
//! counts only while it can change nowhere on the rectangle.
//! Where S_u x S_v vanishes on a border (poles, collapsed sides) the factor is divided out and
//! |w_t| = |w x M| / |M| is used instead. Rectangles are halved, across the direction in which S_u x S_v changes more, until
//! the bound passes, 400 of them a piece at most. Normals are
//! one-sided by construction, because every rectangle is one polynomial piece. All bounds are inflated
//! for rounding.
#pragma once

#include "../input/input_face.h"
#include "../spline/tensor_spline.h"

#include <functional>
#include <optional>

namespace laminate_offset
{

//! Does a rectangle of parameters have to be covered? Answering yes too often only costs time.
using RectangleFilter = std::function<bool(const ParameterBox &)>;

struct CertificateRequest
{
    const TensorSpline &base;
    const TensorSpline &offset; //!< polynomial, or rational over the base's own weight function
    double distance = 0.0;      //!< along S_u x S_v [mm]
    double target = 0.0;        //!< the bound to prove [mm]
    RectangleFilter needed;     //!< empty: everywhere
    //! How far the base's poles may be from those that are meant, in units of rounding of its largest coordinates.
    double base_operations = 0.0;
    //! Only the answer matters, not the bound: the first rectangle that misses the target ends the proof.
    bool settle = false;
};

struct Certificate
{
    //! Proven bound over the needed rectangles [mm]; infinite where none could be proven or the proof was ended.
    double bound = 0.0;
    bool proven = true; //!< bound <= target
    ParameterBox worst; //!< rectangle of the largest bound
};

Certificate certify(const CertificateRequest &request);

} // namespace laminate_offset
