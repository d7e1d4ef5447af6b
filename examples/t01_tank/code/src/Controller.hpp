// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef TANK_CONTROLLER_HPP
#define TANK_CONTROLLER_HPP

#include <tank/ControllerBase.hpp>

namespace tank {

/// Takes samples from its port, one in each cycle, and counts them.
class Controller : public ControllerBase {
public:
    explicit Controller(const std::string& name);
    ~Controller() override;

    bool finish(int sent, int refused) override;

protected:
    bool startHook() override;
    void updateHook() override;

private:
    bool readOne();

    LevelSample sample_;
    int out_of_order_ = 0;
};

}  // namespace tank

#endif
