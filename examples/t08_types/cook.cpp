// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with a property of a type that typegen has read.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <t08_types/recipe.hpp>

#include <iostream>

class Cook : public RTT::TaskContext {
public:
    explicit Cook(const std::string& name) : TaskContext(name) {
        addProperty("recipe", recipe).doc("What is cooked.");
        addOperation("show", &Cook::show, this);
    }

private:
    void show() {
        for (const auto& [name, ingredient] : recipe.ingredients)
            std::cout << "C++ sees " << name << ": " << ingredient.amount << "\n";
        std::cout << "C++ sees stars " << recipe.stars << ", time " << recipe.time.count() << " min, oven "
                  << recipe.oven.temperature() << "\n";
        std::cout << getProperty("recipe")->getDataSource() << std::endl;
    }

    recipe::Recipe recipe;
};

ORO_CREATE_COMPONENT(Cook)
