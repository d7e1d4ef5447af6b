#include <tank/RecorderBase.hpp>
class Recorder : public RecorderBase {
public:
    void record() override {
    }
};
