#include <tank/PlantBase.hpp>
struct Plant : PlantBase { Plant(const std::string& n) : PlantBase(n) {}

    int gripper_open() override {
        return {};
    } };
