// The numbers of a comparison by their names in compare.json: one table for the way out and back.
#pragma once

#include <array>

#include "lab/compare/comparison.h"

namespace wander::compare {

template <class Record, class Value>
struct Field {
  const char* name;
  Value Record::*member;
};

inline constexpr std::array cell_fields{
    Field<Cell, Measured>{"seconds", &Cell::seconds},
    Field<Cell, Measured>{"samples", &Cell::samples},
    Field<Cell, Measured>{"relative_rmse", &Cell::relative_rmse},
    Field<Cell, Measured>{"median_relative_rmse", &Cell::median_relative_rmse},
    Field<Cell, Measured>{"rmse", &Cell::rmse},
    Field<Cell, Measured>{"mae", &Cell::mae},
    Field<Cell, Measured>{"rel_mse", &Cell::rel_mse},
    Field<Cell, Measured>{"bias", &Cell::bias},
    Field<Cell, Measured>{"relative_error_of_mean", &Cell::relative_error_of_mean},
    Field<Cell, Measured>{"efficiency", &Cell::efficiency}};
inline constexpr std::array cell_numbers{
    Field<Cell, double>{"claimed_relative_error", &Cell::claimed_relative_error},
    Field<Cell, double>{"coverage", &Cell::coverage}};

inline constexpr std::array curve_fields{
    Field<Curve, Measured>{"slope_time", &Curve::slope_time},
    Field<Curve, Measured>{"slope_samples", &Curve::slope_samples},
    Field<Curve, Measured>{"seconds_to_target", &Curve::seconds_to_target}};

inline constexpr std::array crossing_fields{
    Field<Crossing, Measured>{"seconds", &Crossing::seconds},
    Field<Crossing, Measured>{"speedup", &Crossing::speedup},
    Field<Crossing, Measured>{"efficiency", &Crossing::efficiency}};

inline constexpr std::array error_fields{
    Field<RunErrors, double>{"relative_mse", &RunErrors::relative_mse},
    Field<RunErrors, double>{"relative_rmse", &RunErrors::relative_rmse},
    Field<RunErrors, double>{"rmse", &RunErrors::rmse},
    Field<RunErrors, double>{"mae", &RunErrors::mae},
    Field<RunErrors, double>{"rel_mse", &RunErrors::rel_mse},
    Field<RunErrors, double>{"mean", &RunErrors::mean},
    Field<RunErrors, double>{"relative_error_of_mean", &RunErrors::relative_error_of_mean},
    Field<RunErrors, double>{"claimed_relative_error", &RunErrors::claimed_relative_error},
    Field<RunErrors, double>{"coverage", &RunErrors::coverage},
    Field<RunErrors, double>{"reliable_share", &RunErrors::reliable_share}};

}  // namespace wander::compare
