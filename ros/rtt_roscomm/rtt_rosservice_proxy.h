// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * Connects operations with services of a C++ type, for packages that register their services themselves:
 *
 *     ROSServiceRegistryService::Instance()->registerServiceFactory(
 *         new ROSServiceProxyFactory<my_msgs::Plan>("my_msgs/Plan"));
 *
 * Generated packages need none of this: a table describes their services.
 */
#ifndef RTT_ROSCOMM_RTT_ROSSERVICE_PROXY_H
#define RTT_ROSCOMM_RTT_ROSSERVICE_PROXY_H

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/rosservice_proxy_base.h>

#include <ros/serialization.h>
#include <ros/service_traits.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace rtt_roscomm {

/**
 * How an operation with another signature answers a service. To let operations of more signatures do so, specialise
 * this for variants 1, 2, … in this namespace; the first variant that is missing ends the list:
 *
 *     typedef bool Signature(double);
 *     typedef RTT::OperationCaller<Signature> ProxyOperationCallerType;
 *     template <class Callable>
 *     static bool call(Callable& operation, my_msgs::Plan::Request& request, my_msgs::Plan::Response& response);
 *
 * call() runs in the thread of a spinner; its result false makes the call of the service fail.
 */
template <class SRV, int variant>
struct ROSServiceServerOperationCallerWrapper {};

template <class SRV>
struct ROSServiceServerOperationCallerWrapper<SRV, 0> {
    typedef bool Signature(typename SRV::Request&, typename SRV::Response&);
    typedef RTT::OperationCaller<Signature> ProxyOperationCallerType;
    template <class Callable>
    static bool call(Callable& operation, typename SRV::Request& request, typename SRV::Response& response) {
        return operation(request, response);
    }
};

/** Messages of roscpp. */
template <class T>
class RosCodec final : public MessageCodec {
public:
    const std::type_info& type() const override { return typeid(T); }
    const RTT::types::TypeInfo* info() const override { return RTT::types::Types()->getTypeById(&typeid(T)); }
    RTT::base::DataSourceBase::shared_ptr makeVariable() const override {
        return new RTT::internal::ValueDataSource<T>(T());
    }
    void clear(void* value) const override { *static_cast<T*>(value) = T(); }
    std::size_t size(const void* value) const override {
        return ros::serialization::serializationLength(*static_cast<const T*>(value));
    }
    void encode(const void* value, std::uint8_t* to, std::size_t room) const override {
        ros::serialization::OStream stream(to, static_cast<std::uint32_t>(room));
        ros::serialization::serialize(stream, *static_cast<const T*>(value));
    }
    void decode(const std::uint8_t* from, std::size_t size, void* value) const override {
        ros::serialization::IStream stream(const_cast<std::uint8_t*>(from), static_cast<std::uint32_t>(size));
        ros::serialization::deserialize(stream, *static_cast<T*>(value));
        if (stream.getLength() != 0)
            throw std::runtime_error("the bytes are no " + typeName() + ": " + std::to_string(stream.getLength()) +
                                     " of " + std::to_string(size) + " are left over");
    }
};

/** Answers by a function. */
template <class SRV>
class FunctionAnswer final : public ServiceAnswer {
public:
    typedef std::function<bool(typename SRV::Request&, typename SRV::Response&)> Function;
    FunctionAnswer(const std::string& what, const RTT::OperationInterfacePart& operation, Function function)
        : ServiceAnswer(what, operation), function_(std::move(function)) {}

private:
    ros::SerializedMessage answer(const std::uint8_t* request, std::size_t size) override {
        typename SRV::Request received;
        typename SRV::Response given;
        RosCodec<typename SRV::Request>().decode(request, size, &received);
        if (!function_(received, given)) throw std::runtime_error("it returned false");
        const RosCodec<typename SRV::Response> codec;
        const std::size_t bytes = codec.size(&given);
        return this->response(true, bytes, [&](std::uint8_t* to) { codec.encode(&given, to, bytes); });
    }
    const Function function_;
};

template <class SRV>
ServiceType serviceTypeOf() {
    return {ros::service_traits::DataType<SRV>::value(), ros::service_traits::MD5Sum<SRV>::value()};
}

/** True if an operation can be called with this signature without converting values. */
bool fits(const RTT::OperationInterfacePart& operation, const RTT::internal::CallerSignature& signature);
std::string textOf(const RTT::internal::CallerSignature& signature);

template <class SRV>
class ROSServiceServerProxy : public ROSServiceServerProxyBase {
public:
    typedef typename FunctionAnswer<SRV>::Function ProxyFunction;
    explicit ROSServiceServerProxy(const std::string& service_name) : ROSServiceServerProxyBase(service_name) {}

    bool connect(RTT::TaskContext* owner, RTT::OperationInterfacePart* operation) override {
        if (!operation) return false;
        std::vector<std::string> wanted;
        ProxyFunction function = bound<0>(*operation, wanted);
        if (!function) return refuse(serviceTypeOf<SRV>(), owner, *operation, wanted);
        return advertise(serviceTypeOf<SRV>(), boost::shared_ptr<ServiceAnswer>(new FunctionAnswer<SRV>(
                                                   describe(owner, *operation), *operation, std::move(function))));
    }

private:
    template <class Wrapper, class = void>
    struct Exists : std::false_type {};
    template <class Wrapper>
    struct Exists<Wrapper, std::void_t<typename Wrapper::Signature>> : std::true_type {};

    template <int variant>
    static ProxyFunction bound(RTT::OperationInterfacePart& operation, std::vector<std::string>& wanted) {
        typedef ROSServiceServerOperationCallerWrapper<SRV, variant> Wrapper;
        if constexpr (Exists<Wrapper>::value) {
            const auto& signature = RTT::internal::CallerSignatureOf<typename Wrapper::Signature>::signature;
            if (!fits(operation, signature)) {
                wanted.push_back(textOf(signature));
                return bound<variant + 1>(operation, wanted);
            }
            typedef typename Wrapper::ProxyOperationCallerType Caller;
            const Caller caller(&operation, RTT::internal::GlobalEngine::Instance());
            return [caller](typename SRV::Request& request, typename SRV::Response& response) {
                Caller own(caller);  // spinners may call at the same time
                if (!own.ready()) throw std::runtime_error("the component that provides it was destroyed");
                return Wrapper::call(own, request, response);
            };
        } else {
            (void)operation;
            (void)wanted;
            return ProxyFunction();
        }
    }
};

template <class SRV>
class ROSServiceClientProxy : public ROSServiceClientProxyBase {
public:
    typedef RTT::OperationCaller<bool(typename SRV::Request&, typename SRV::Response&)> ProxyOperationCallerType;
    explicit ROSServiceClientProxy(const std::string& service_name) : ROSServiceClientProxyBase(service_name) {}

    bool connect(RTT::TaskContext* owner, RTT::base::OperationCallerBaseInvoker* caller) override {
        return caller && bind(serviceTypeOf<SRV>(),
                              standardForm(std::make_shared<RosCodec<typename SRV::Request>>(),
                                           std::make_shared<RosCodec<typename SRV::Response>>()),
                              owner, *caller);
    }
};

template <class SRV>
class ROSServiceProxyFactory : public ROSServiceProxyFactoryBase {
public:
    explicit ROSServiceProxyFactory(const std::string& service_type) : ROSServiceProxyFactoryBase(service_type) {}
    ROSServiceClientProxyBase* create_client_proxy(const std::string& service_name) override {
        return new ROSServiceClientProxy<SRV>(service_name);
    }
    ROSServiceServerProxyBase* create_server_proxy(const std::string& service_name) override {
        return new ROSServiceServerProxy<SRV>(service_name);
    }
};

}  // namespace rtt_roscomm

// As in versions before 2.10.
using rtt_roscomm::ROSServiceClientProxy;
using rtt_roscomm::ROSServiceProxyFactory;
using rtt_roscomm::ROSServiceServerOperationCallerWrapper;
using rtt_roscomm::ROSServiceServerProxy;

#endif
