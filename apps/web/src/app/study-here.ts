import { study } from '#features/study/feature.ts'
import { loadPart } from '#parts/feature.ts'
import { studyIsOn } from '#storage/study-sign.ts'

/** Where a card leads while a study is open on this device: to the child's own project, or nowhere. Undefined: there is no study. */
export async function studyPlace(card: string): Promise<{ readonly project: string } | null | undefined> {
  return studyIsOn() ? (await loadPart(study)).placeFor(card) : undefined
}
