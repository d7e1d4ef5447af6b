#pragma once
#include <plant/PlantBase.hpp>

class Plant : public PlantBase {
public:
    explicit Plant(const std::string& name) : PlantBase(name) {}
};
