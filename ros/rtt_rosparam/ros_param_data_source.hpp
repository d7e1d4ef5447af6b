// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_ROS_PARAM_DATA_SOURCE_HPP
#define RTT_ROSPARAM_ROS_PARAM_DATA_SOURCE_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt_rosparam/parameter_binding.hpp>

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace rtt_rosparam {

/**
 * A value that is a parameter: reading it reads the parameter (from a cache), assigning it sets the parameter, which
 * waits for the master. While the parameter cannot be read, there is an error in the log and the last value that could
 * be. A change through a reference sets it in updated(), or when the value is read next.
 *
 * Several threads may read, assign and update it; they wait for each other, also while one waits for the master. A
 * reference, that of rvalue() as well, is for one thread while no other uses the source. Not real-time safe.
 */
template <typename T>
class RosParamDataSource : public RTT::internal::AssignableDataSource<T> {
public:
    typedef RTT::internal::AssignableDataSource<T> Base;
    typedef boost::intrusive_ptr<RosParamDataSource<T>> shared_ptr;
    typedef typename RTT::internal::DataSource<T>::result_t result_t;
    typedef typename Base::param_t param_t;
    typedef typename Base::reference_t reference_t;
    typedef typename RTT::internal::DataSource<T>::const_reference_t const_reference_t;

    /** A name of ROS: "/a/b", "~b" or relative. */
    explicit RosParamDataSource(const std::string& full_name) : binding_(full_name, typeid(T)), last_() {}

    bool evaluate() const override {
        const Lock lock(mutex_);
        read();
        return true;
    }
    result_t get() const override {
        const Lock lock(mutex_);
        read();
        return last_;
    }
    /** The last value that was read or set. */
    result_t value() const override {
        const Lock lock(mutex_);
        return last_;
    }
    const_reference_t rvalue() const override {
        const Lock lock(mutex_);
        read();
        return last_;
    }
    void set(param_t value) override {
        const Lock lock(mutex_);
        last_ = value;
        (void)binding_.write(&last_);
        if (isReferred_) binding_.lend(&last_);
    }
    reference_t set() override {
        const Lock lock(mutex_);
        read();
        isReferred_ = true;
        binding_.lend(&last_);
        return last_;
    }
    void updated() override {
        const Lock lock(mutex_);
        binding_.settle(&last_);
    }

    RosParamDataSource<T>* clone() const override { return new RosParamDataSource<T>(binding_.name()); }
    RosParamDataSource<T>* copy(
        std::map<const RTT::base::DataSourceBase*, RTT::base::DataSourceBase*>&) const override {
        return const_cast<RosParamDataSource<T>*>(this);
    }

private:
    typedef std::lock_guard<std::mutex> Lock;
    /** Assigns only what is new, for those who hold a reference. */
    void read() const {
        binding_.settle(&last_);
        T value(last_);
        if (binding_.read(&value)) last_ = std::move(value);
    }

    mutable std::mutex mutex_;
    mutable ParameterBinding binding_;
    mutable T last_;
    bool isReferred_ = false;
};

}  // namespace rtt_rosparam

#endif
