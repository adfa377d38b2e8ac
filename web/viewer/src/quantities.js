// What the flow can be coloured by, as in the values of a frame behind place and height.
export const quantities = [
  { key: 'depth', unit: 'm', scale: 1, digits: 2 },
  { key: 'speed', unit: 'm/s', scale: 1, digits: 2 },
  { key: 'pressure', unit: 'kPa', scale: 1e-3, digits: 1 },
];
