// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_FILE_REPORTING_HPP
#define ORO_OCL_FILE_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

namespace OCL {

/** Reports to the file that the property ReportFile names; start() begins it anew and stop() completes it. */
class OCL_API FileReporting : public ReportingComponent {
public:
    explicit FileReporting(const std::string& name = "FileReporting");
    ~FileReporting() override;

    /** Writes to the file `<component>.screen`. */
    bool screenComponent(const std::string& component) override;

protected:
    bool startHook() override;

private:
    std::string reportFile_ = "reports.dat";
};

}  // namespace OCL

#endif
