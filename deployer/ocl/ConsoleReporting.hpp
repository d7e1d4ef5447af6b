// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_CONSOLE_REPORTING_HPP
#define ORO_OCL_CONSOLE_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

#include <iostream>

namespace OCL {

/** Reports to a stream, usually the console. Between start() and stop(), a separate thread writes to the stream.
    The property Format is as that of FileReporting. */
class OCL_API ConsoleReporting : public ReportingComponent {
public:
    explicit ConsoleReporting(std::string name = "ConsoleReporting", std::ostream& console = std::cerr);
    ~ConsoleReporting() override;

    bool screenComponent(const std::string& component) override;

protected:
    bool configureHook() override;
    bool startHook() override;

private:
    std::ostream& console_;
    std::string format_ = "columns";
};

}  // namespace OCL

#endif
