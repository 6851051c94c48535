import { schoolClass } from '#features/class/feature.ts'
import { loadPart } from '#parts/feature.ts'
import { account } from '#storage/account.ts'

/**
 * What a pupil has made of this project on another device comes first, where the class can be reached soon. Whoever is in
 * no class fetches nothing: a page that imports the feature itself would load its part at once.
 */
export async function bringClassWork(project: string): Promise<void> {
  if (account())
    await loadPart(schoolClass).then(({ memberHere, soon }) => soon(memberHere()!.fetchWork(project)))
}
