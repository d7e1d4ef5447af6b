#ifndef ACTS_SEQUENTIAL_HPP
#define ACTS_SEQUENTIAL_HPP

#include <acts/SequentialBase.hpp>

namespace acts {

/// Ports, properties and attributes are members of the base class: SequentialBase, generated from acts.xml.
class Sequential : public SequentialBase {
public:
    explicit Sequential(const std::string& name);
    ~Sequential() override;

protected:
    bool configureHook() override;
    void errorHook() override;
    void exceptionHook() override;
};

}  // namespace acts

#endif
