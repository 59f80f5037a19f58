% W1 in Octave: Euler-Cromer as a loop. Prints row, who, seconds.
1;
function run()
  n = 8000; h = 0.01; t = zeros(n + 1, 1); x = zeros(n + 1, 1); v = zeros(n + 1, 1);
  for i = 1:n
    t(i + 1) = i * h;
    v(i + 1) = v(i) + h * (cos(3 * t(i)) - 9 * x(i) - 0.2 * v(i));
    x(i + 1) = x(i) + h * v(i + 1);
  end
end
seconds = zeros(7, 1);
for k = 1:7
  tic; run(); seconds(k) = toc;
end
printf("linear, euler-cromer\tOctave\t%.9g\n", median(seconds));
