/** The twelve pictures that make a pupil's secret, as they stand on the screen. The server knows the same names. */
export const secretPictures = [
  'tree',
  'cup',
  'boat',
  'star',
  'house',
  'fish',
  'leaf',
  'key',
  'sun',
  'ball',
  'flag',
  'moon',
] as const

export type SecretPicture = (typeof secretPictures)[number]
