#pragma once
namespace bad {
class Account {
public:
    double balance() const { return balance_; }
protected:
    int number;
private:
    double balance_ = 0;
};
}
