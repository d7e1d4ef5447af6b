// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <variant>

namespace recipe {

enum class Unit : unsigned char { Gram, Litre };

struct Ingredient {
    double amount = 0;
    Unit unit = Unit::Gram;
};

class Oven {
public:
    double temperature() const { return temperature_; }
    void setTemperature(double temperature) { temperature_ = temperature; }

private:
    double temperature_ = 20;  ///< inside @unit C @range 20..250
};

struct Recipe {
    std::string name;
    std::map<std::string, Ingredient> ingredients;
    std::optional<int> servings;
    std::variant<std::string, double> price;  ///< a text, or a number
    std::chrono::minutes time{0};             ///< from start to end
    double tray[2][3] = {};                   ///< what lies where
    unsigned vegan : 1;
    unsigned stars : 3;
    Oven oven;

    Recipe() : vegan(0), stars(0) {}
};

}  // namespace recipe
