// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Result<T>: a value, or a Failure that says what, where and what would work. The core
//! never throws across its API for bad geometry.
#pragma once

#include "status.h"

#include <Standard_Failure.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace laminate_offset
{

//! A place on the base face: parameters and the point in space [mm].
struct Where
{
    gp_Pnt2d uv;
    gp_Pnt point;
};

//! Signed distances [mm] along the face's outward normal between which the offset is regular.
//! An empty side is unbounded.
struct FeasibleRange
{
    std::optional<double> negative; //!< most negative feasible distance, <= 0
    std::optional<double> positive; //!< largest feasible distance, >= 0

    friend bool operator==(const FeasibleRange &, const FeasibleRange &) = default;
};

//! The distances that are feasible in both ranges.
FeasibleRange tightest(const FeasibleRange &a, const FeasibleRange &b);

//! A refusal: never silent, always with a status and a stage.
struct Failure
{
    Status status = Status::KernelError;
    Stage stage = Stage::Input;
    std::string message;                         //!< one or two sentences that name the thing and the remedy
    std::optional<Where> where;                  //!< the place on the base face, when there is one
    std::optional<FeasibleRange> feasible_range; //!< what would work, when that is known
};

//! What an exception of OpenCASCADE becomes at the stage that met it.
Failure kernel_failure(const Standard_Failure &error, Stage stage);

//! Either a T or a Failure.
template <typename T> class Result
{
public:
    Result(T value) : m_content(std::move(value)) {}
    Result(Failure failure) : m_content(std::move(failure)) {}

    [[nodiscard]] bool ok() const { return std::holds_alternative<T>(m_content); }
    explicit operator bool() const { return ok(); }

    //! Precondition: ok().
    const T &value() const & { return std::get<T>(m_content); }
    T &value() & { return std::get<T>(m_content); }
    T &&value() && { return std::get<T>(std::move(m_content)); }

    //! Precondition: !ok().
    [[nodiscard]] const Failure &failure() const { return std::get<Failure>(m_content); }

private:
    std::variant<T, Failure> m_content;
};

} // namespace laminate_offset
