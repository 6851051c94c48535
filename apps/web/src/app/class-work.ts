import { schoolClass } from '#features/class/feature.ts'
import { loadPart } from '#parts/feature.ts'
import { owner } from '#storage/owner.ts'

/**
 * What a pupil has made of this project on another device comes first, where the class can be reached soon. Whoever is in
 * no class fetches nothing: a page that imports the feature itself would bring its part along at once.
 */
export async function bringClassWork(project: string): Promise<void> {
  if (owner()) await loadPart(schoolClass).then(({ memberHere, soon }) => soon(memberHere()!.bring(project)))
}
