int functionThatNobodyHas();
int linkedUnused() { return functionThatNobodyHas(); }
