import type { Difference } from '@botgarten/programs/open-roberta'
import { goto, replaceState } from '$app/navigation'
import { resolve } from '$app/paths'
import { page } from '$app/state'
import { placeOf } from '#content/cards.ts'
import { openRoberta } from '#features/open-roberta/feature.ts'
import { sorting, type SortingLink } from '#features/sorting/feature.ts'
import type { Opened } from '#lab/opening.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { freshId } from '#storage/projects.ts'
import { nameOfCopy } from '#storage/messages.ts'
import { loadPart } from '#parts/feature.ts'
import { fetchWords } from '#words/message.ts'

const asked = (id: string) => `/lab/[card]?p=${encodeURIComponent(id)}` as const
const show = (card: string, id: string, state: App.PageState = {}) =>
  goto(resolve(asked(id), { card }), { invalidateAll: true, state })
/** Gives what is shown another address; nothing is loaded. */
const rename = (card: string, id: string) => void replaceState(resolve(asked(id), { card }), {})

/** Opens a project file in place of this project, which stays on the device. */
export async function openFile(file: File, ui: LabUi): Promise<void> {
  const { openProjectFile } = await import('#storage/files.ts')
  const outcome = await openProjectFile(file)
  if ('problem' in outcome) {
    await fetchWords('files')
    const { problem, facts } = outcome
    ui.announce(`problem.${problem}.title`, `problem.${problem}.text`, facts)
  } else if ('merged' in outcome) await goto(resolve('/projects'), { state: { merged: outcome.merged } })
  else await show(placeOf(outcome.project), outcome.id, { lost: outcome.lost ?? false, fromFile: true })
}

/** What may end the robot's program here and not in Open Roberta, where the program comes from there. */
export async function foreignDifferences(session: LabSession): Promise<readonly Difference[]> {
  if (!session.program.raw) return []
  const { differencesOf } = await loadPart(openRoberta)
  return differencesOf(session.program, session.config)
}

/** Another tab has saved this project: what stands here becomes one of its own, and goes on undisturbed. */
export function keepCopy(session: LabSession, title: string): void {
  const place = placeOf(session.project)
  const id = freshId(place)
  void session.continueAsCopy(id, nameOfCopy(title, []))
  rename(place, id)
}

/** Another tab has thrown this project away: what stands here goes on as one of its own. */
export function keepGone(session: LabSession): void {
  const place = placeOf(session.project)
  const id = freshId(place)
  void session.continueAsCopy(id, session.name)
  rename(place, id)
}

/** Another tab has saved this project: that is shown. What stands here is put aside first. */
export async function loadNewer(session: LabSession, ui: LabUi, title: string): Promise<void> {
  const place = placeOf(session.project)
  const safe = await session.autosave.putAside(freshId(place), nameOfCopy(title, []))
  if (safe) await show(place, session.autosave.id)
  else ui.announce('problem.notKept.title', 'problem.notKept.text')
}

/** Ways into the sorting playground, for a project that sorts or a robot that has collected something. */
export async function sortingLinks(session: LabSession): Promise<readonly SortingLink[]> {
  const { robots } = session.lab.document.world
  const thread = session.lab.moment.threads[robots.findIndex(({ id }) => id === session.robotId)]
  const readings = thread?.sorting.readings ?? []
  const sorts = session.opened.card?.card.playground === 'sorting' || session.project.sorting
  if (!sorts && readings.length === 0) return []
  return (await loadPart(sorting)).linksFor(session, readings)
}

/** Removes `start` from the address, and nothing else: a lab that is loaded again waits for its child. */
export function forgetStart({ project, damaged }: Opened): void {
  // leaveBroken gives a damaged project's replacement an address without it.
  if (damaged) return
  const others = new URLSearchParams(page.url.search)
  others.delete('start')
  const rest = others.toString()
  const card = placeOf(project)
  void replaceState(
    rest === '' ? resolve('/lab/[card]', { card }) : resolve(`/lab/[card]?${rest}`, { card }),
    page.state,
  )
}

/** What could not be read here stays where it is: the new start has an address of its own from now on. */
export function leaveBroken({ id, project, damaged }: Opened): void {
  if (damaged) rename(placeOf(project), id)
}
