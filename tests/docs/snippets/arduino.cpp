struct {
  template <class T>
  void print(T);
  template <class T>
  void println(T);
} Serial;
unsigned long millis();
void delay(unsigned long);
float distance_cm();
// here
