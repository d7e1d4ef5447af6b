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
          updateFile("updateFile"),
          loadServiceProperties("loadServiceProperties"),
          storeServiceProperties("storeServiceProperties"),
          readServiceProperties("readServiceProperties"),
          updateServiceProperties("updateServiceProperties"),
          writeServiceProperties("writeServiceProperties"),
          updateServiceFile("updateServiceFile"),
          readServiceProperty("readServiceProperty"),
          writeServiceProperty("writeServiceProperty") {
        for (auto* caller :
             {&loadProperties, &storeProperties, &readProperties, &updateProperties, &writeProperties, &updateFile})
            addOperationCaller(*caller);
        for (auto* caller :
             {&readProperty, &writeProperty, &loadServiceProperties, &storeServiceProperties, &readServiceProperties,
              &updateServiceProperties, &writeServiceProperties, &updateServiceFile})
            addOperationCaller(*caller);
        for (auto* caller : {&readServiceProperty, &writeServiceProperty}) addOperationCaller(*caller);
    }

    typedef OperationCaller<bool(const std::string&)> OfFile;
    typedef OperationCaller<bool(const std::string&, const std::string&)> OfFileAndName;
    typedef OperationCaller<bool(const std::string&, const std::string&, const std::string&)> OfFileNameAndService;

    OfFile loadProperties;
    OfFile storeProperties;
    OfFile readProperties;
    OfFileAndName readProperty;
    OfFile updateProperties;
    OfFile writeProperties;
    OfFileAndName writeProperty;
    OfFile updateFile;
    // The last argument is the name of a service of the component.
    OfFileAndName loadServiceProperties;
    OfFileAndName storeServiceProperties;
    OfFileAndName readServiceProperties;
    OfFileAndName updateServiceProperties;
    OfFileAndName writeServiceProperties;
    OfFileAndName updateServiceFile;
    OfFileNameAndService readServiceProperty;
    OfFileNameAndService writeServiceProperty;
};

}  // namespace RTT

#endif
