// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MARSHALLING_HPP
#define ORO_MARSHALLING_HPP

#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>
#include <string>

namespace RTT {

/** Calls the service "marshalling": component->getProvider<RTT::Marshalling>("marshalling")->loadProperties(file). */
class Marshalling : public ServiceRequester {
public:
    explicit Marshalling(TaskContext* owner = nullptr)
        : ServiceRequester("marshalling", owner),
          loadProperties("loadProperties"),
          storeProperties("storeProperties"),
          readProperties("readProperties"),
          readProperty("readProperty"),
          updateProperties("updateProperties"),
          writeProperties("writeProperties"),
          writeProperty("writeProperty"),
          updateFile("updateFile") {
        addOperationCaller(loadProperties);
        addOperationCaller(storeProperties);
        addOperationCaller(readProperties);
        addOperationCaller(readProperty);
        addOperationCaller(updateProperties);
        addOperationCaller(writeProperties);
        addOperationCaller(writeProperty);
        addOperationCaller(updateFile);
    }

    OperationCaller<bool(const std::string&)> loadProperties;
    OperationCaller<bool(const std::string&)> storeProperties;
    OperationCaller<bool(const std::string&)> readProperties;
    OperationCaller<bool(const std::string&, const std::string&)> readProperty;
    OperationCaller<bool(const std::string&)> updateProperties;
    OperationCaller<bool(const std::string&)> writeProperties;
    OperationCaller<bool(const std::string&, const std::string&)> writeProperty;
    OperationCaller<bool(const std::string&)> updateFile;
};

}  // namespace RTT

#endif
