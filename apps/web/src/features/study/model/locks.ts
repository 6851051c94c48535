import { openMaps } from '@botgarten/blocks'
import { allowed } from '#lab/allowed.svelte.ts'
import { projectsOf } from '#storage/study.ts'
import { device } from './device.svelte.ts'

/** Leaves open what the study of this device leaves open to the child that sits here. */
export function lockLab(): void {
  const { plan, child } = device
  if (!plan) {
    allowed.set({ cards: null, level: null })
    openMaps(null)
    return
  }
  const module = child ? device.modules[child.part] : undefined
  allowed.set({ cards: module?.cards ?? [], level: plan.level, strict: true })
  openMaps(plan.maps)
}

device.listen(lockLab)

/** The project that a child of the study works on where it opens a card; null where that is closed. */
export function placeFor(card: string): { readonly project: string } | null {
  lockLab()
  const { child } = device
  if (!child || !allowed.isOpen(card)) return null
  return { project: `${projectsOf(child.pseudonym)}${card}` }
}
