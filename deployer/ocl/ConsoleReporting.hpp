// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_CONSOLE_REPORTING_HPP
#define ORO_OCL_CONSOLE_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

#include <iostream>

namespace OCL {

/** Reports to a stream, usually the console. Between start() and stop(), a separate thread writes to the stream. */
class OCL_API ConsoleReporting : public ReportingComponent {
public:
    explicit ConsoleReporting(std::string name = "ConsoleReporting", std::ostream& console = std::cerr);
    ~ConsoleReporting() override;

    bool screenComponent(const std::string& component) override;

protected:
    bool startHook() override;

private:
    std::ostream& console_;
};

}  // namespace OCL

#endif
