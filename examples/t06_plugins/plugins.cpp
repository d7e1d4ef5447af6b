// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads a typekit and a service that are in libraries of their own, and keeps the properties of a component in a file.
#include "gains.hpp"

#include <rtt/RTT.hpp>
#include <rtt/marsh/Marshalling.hpp>
#include <rtt/os/main.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <fstream>
#include <iostream>

using namespace RTT;

namespace {

class Controller : public TaskContext {
public:
    explicit Controller(const std::string& name) : TaskContext(name) {
        addProperty("gains", gains).doc("The gains of the loop.");
        addProperty("rate", rate).doc("How often it runs, in Hz.");
    }

    control::Gains gains;
    double rate = 100;
};

void show(Controller& controller) {
    std::cout << "gains " << controller.getProperty("gains")->getDataSource() << ", rate " << controller.rate << "\n";
}

void typekit() {
    const types::TypeInfo* const type = types::Types()->type("Gains");
    std::cout << "members:";
    for (const std::string& member : type->getMemberNames()) std::cout << ' ' << member;
    const base::DataSourceBase::shared_ptr made = type->construct({new internal::ConstantDataSource<double>(2)});
    std::cout << "\nGains(2) is " << made << "\n";
}

void service(Controller& controller) {
    std::cout << "tuning can be loaded: " << controller.loadService("tuning") << "\n";
    OperationCaller<bool(std::string, double)> scale(controller.provides("tuning")->getOperation("scale"),
                                                     controller.engine());
    std::cout << "scaled: " << scale("gains", 10) << scale("rate", 0.5) << scale("name", 2) << "\n";
}

void print(const char* file) { std::cout << std::ifstream(file).rdbuf(); }

void file(Controller& controller) {
    const auto marshalling = controller.getProvider<Marshalling>("marshalling");
    std::ofstream("controller.cpf") << R"(<properties>
  <!-- found on the test bench -->
  <simple name="rate" type="double"><value>1000</value></simple>
  <simple name="operator" type="string"><value>Ada &amp; Grace</value></simple>
</properties>
)";
    std::cout << "updated from the file: " << marshalling->updateProperties("controller.cpf") << "\n";
    show(controller);
    controller.rate = 250;
    std::cout << "written to the file: " << marshalling->writeProperties("controller.cpf") << "\n";
    print("controller.cpf");
    controller.gains = control::Gains();
    std::cout << "read again: " << marshalling->readProperties("controller.cpf") << "\n";
    show(controller);
}

}  // namespace

int ORO_main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: plugins FOLDER\n";
        return 2;
    }
    Logger::Instance()->setLogLevel(Logger::Never);  // what is logged carries the time
    const boost::shared_ptr<plugin::PluginLoader> loader = plugin::PluginLoader::Instance();
    std::cout << std::boolalpha;
    const bool loaded = loader->loadTypekits(argv[1]) && loader->loadPlugins(argv[1]);
    std::cout << "loaded: " << loaded << "\n";
    if (!loaded) return 1;
    typekit();
    Controller controller("controller");
    controller.gains.p = 1.5;
    controller.gains.limits = {-1, 1};
    show(controller);
    service(controller);
    show(controller);
    file(controller);
    return 0;
}
