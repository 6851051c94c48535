/** Where a study of this device lies: it is one for all who use it. */
export const placeOfStudy = 'botgarten.study'

/** Is a study open on this device? A cheap look: without one nothing of study mode is loaded. */
export function studyIsOn(): boolean {
  try {
    return localStorage.getItem(placeOfStudy) !== null
  } catch {
    return false
  }
}
