#ifndef VALUES_ALL_HPP
#define VALUES_ALL_HPP

#include <values/AllBase.hpp>

namespace values {

/// Every type with a notation of its own. "Quoted" and \back\ .
/// Ports, properties and attributes are members of the base class: AllBase, generated from values.xml.
class All : public AllBase {
public:
    explicit All(const std::string& name);
    ~All() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

}  // namespace values

#endif
