export * from './types.ts'
export {
  countOf,
  isCage,
  learnIn,
  mendedIn,
  mending,
  minutes,
  rowsOf,
  shownIn,
  watchedIn,
  type Mended,
  type Place,
} from './cages.ts'
