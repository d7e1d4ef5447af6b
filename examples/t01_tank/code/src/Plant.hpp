// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef TANK_PLANT_HPP
#define TANK_PLANT_HPP

#include <tank/PlantBase.hpp>

#include <rtt/OperationCaller.hpp>

namespace tank {

/// Publishes `samples` samples, one in each cycle, and then tells its peer how many there were.
class Plant : public PlantBase {
public:
    explicit Plant(const std::string& name);
    ~Plant() override;

protected:
    bool startHook() override;
    void updateHook() override;

private:
    LevelSample sample_;
    int refused_ = 0;
    RTT::OperationCaller<bool(int, int)> finish_;
};

}  // namespace tank

#endif
