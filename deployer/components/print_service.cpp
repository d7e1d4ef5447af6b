// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service `print`, for scripts: lines to the console and the log.
#include <rtt/Logger.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/GlobalsRepository.hpp>

#include <iostream>
#include <string>

namespace OCL {
namespace {

const struct {
    const char* name;
    RTT::LoggerLevel level;
} kLevels[] = {
    {"Never", RTT::Never},     {"Fatal", RTT::Fatal}, {"Critical", RTT::Critical}, {"Error", RTT::Error},
    {"Warning", RTT::Warning}, {"Info", RTT::Info},   {"Debug", RTT::Debug},       {"RealTime", RTT::RealTime},
};

class LogLevelType : public RTT::types::EnumTypeInfo<RTT::LoggerLevel> {
public:
    LogLevelType() : EnumTypeInfo("LogLevel") {
        for (const auto& known : kLevels) to_string[known.level] = known.name;
    }
};

/** Makes the log levels global names in scripts, once per process. */
void registerLevels() {
    if (RTT::types::Types()->getTypeInfo<RTT::LoggerLevel>()) return;
    RTT::types::Types()->addType(new LogLevelType());
    for (const auto& known : kLevels)
        RTT::types::GlobalsRepository::Instance()->addConstant(known.name, RTT::LoggerLevel(known.level));
}

}  // namespace

class PrintService : public RTT::Service {
public:
    explicit PrintService(RTT::TaskContext* owner) : RTT::Service("print", owner) {
        registerLevels();
        doc("Writes lines.");
        addOperation("ln", &PrintService::ln, this).doc("Writes to standard output.").arg("line", "The line");
        addOperation("err", &PrintService::err, this).doc("Writes to standard error.").arg("line", "The line");
        addOperation("log", &PrintService::log, this)
            .doc("Writes to the log.")
            .arg("level", "Never, Fatal, Critical, Error, Warning, Info, Debug or RealTime")
            .arg("line", "The line");
    }

private:
    void ln(const std::string& line) { std::cout << line + "\n" << std::flush; }
    void err(const std::string& line) { std::cerr << line + "\n" << std::flush; }
    void log(RTT::LoggerLevel level, const std::string& line) { RTT::log(level) << line << RTT::endlog(); }
};

}  // namespace OCL

ORO_SERVICE_NAMED_PLUGIN(OCL::PrintService, "print")
