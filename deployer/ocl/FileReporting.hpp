// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_FILE_REPORTING_HPP
#define ORO_OCL_FILE_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

namespace OCL {

/**
 * Reports to the file that the property ReportFile names; start() begins it anew and stop() completes it. The property
 * Format is "columns", with blanks between fields, or "csv"; configure() and start() fail for any other.
 */
class OCL_API FileReporting : public ReportingComponent {
public:
    explicit FileReporting(const std::string& name = "FileReporting");
    ~FileReporting() override;

    /** Writes to the file `<component>.screen`. */
    bool screenComponent(const std::string& component) override;

protected:
    bool configureHook() override;
    bool startHook() override;

private:
    std::string reportFile_ = "reports.dat";
    std::string format_ = "columns";
};

}  // namespace OCL

#endif
