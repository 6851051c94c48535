import type { Facts } from '@botgarten/blocks'
import {
  isCardFile,
  parseCardFile,
  parseProject,
  ProjectError,
  salvageProject,
  type Project,
} from '@botgarten/programs/project'
import { loadFreeLab, placeOf } from '#content/cards.ts'
import { shownName } from '#content/names.ts'
import { fetchWords, m } from '#words/message.ts'
import { nameOfCopy } from './messages.ts'
import { storageErrorOf } from './database.ts'
import { isOpenRoberta, handOut } from './handout.ts'
import { addToBin, listBin } from './bin.ts'
import { isHome, mostHomeBytes, packHome, readHome, mergeBin, mergeHome } from './home-file.ts'
import { deviceDrawer, follow, mergeSettings, settingsIn, type HomeSettings } from './home-settings.ts'
import { moveOldSorting } from './old-sorting.ts'
import { add, freshId, listWhole, save } from './projects.ts'

/** Why a file was not taken up, as the words `problem.<problem>.title` and `.text` with their facts. */
interface Refusal {
  readonly problem: string
  readonly facts: Facts
}

/** How many projects of a home file are new here, stand here as a copy, were here already, came into the bin, or are broken. */
export interface Merged {
  readonly added: number
  readonly copies: number
  readonly same: number
  readonly binned: number
  readonly broken: number
  /** Have settings come along? Are there others here, which stay? */
  readonly settings: { readonly taken: boolean; readonly kept: boolean }
}

/** `lost`: it was too much, and only what could be opened is here. */
interface OpenedProject {
  readonly id: string
  readonly project: Project
  readonly lost?: boolean
}

/** A file of one project is a new project of this device; a home file lays its projects beside those that are here. */
export type OpenedFile = OpenedProject | { readonly merged: Merged } | Refusal

const MOST_BYTES = 5_000_000

/** Takes a file up; what is here already stays as it is. */
export async function openProjectFile(file: File): Promise<OpenedFile> {
  if (file.size > mostHomeBytes) return { problem: 'homeTooBig', facts: {} }
  try {
    if (/\.xml$/i.test(file.name) && file.size > MOST_BYTES) return { problem: 'tooBig', facts: {} }
    const text = await file.text()
    if (isOpenRoberta(file.name, text)) return await takeOpenRoberta(text, file.name)
    const home = homeIn(text)
    if (home) return await takeHomeFile(home)
    if (file.size > MOST_BYTES) return { problem: 'tooBig', facts: {} }
    return await takeProject(text)
  } catch (error) {
    if (!(error instanceof ProjectError)) throw error
    console.warn('The project file was refused.', error)
    return { problem: error.reason, facts: error.facts }
  }
}

/** Of a project that is too much what can be opened; the child still has the file. */
async function takeProject(text: string): Promise<OpenedFile> {
  try {
    return await keepProject(isCard(text) ? parseCardFile(text) : parseProject(text))
  } catch (error) {
    const isOver = error instanceof ProjectError && error.limit !== undefined && error.reason !== 'tooBig'
    // Of a card that is too much nothing is taken: it could no longer be solved.
    if (!isOver || isCard(text)) throw error
    const salvaged = salvageProject(JSON.parse(text), await loadFreeLab())
    if (!salvaged) throw error
    const opened = await keepProject(salvaged.project)
    return 'id' in opened ? { ...opened, lost: true } : opened
  }
}

/** An Open Roberta file, in the world of the free lab. @throws {ProjectError} and nothing else of the file's */
async function takeOpenRoberta(text: string, name: string): Promise<OpenedFile> {
  const [{ projectFrom }, { world }] = await Promise.all([
    import('@botgarten/programs/open-roberta'),
    loadFreeLab(),
  ])
  return keepProject(projectFrom(text, name.replace(/\.xml$/i, '').slice(0, 100), world))
}

/** Does it say that it is a card? */
function isCard(text: string): boolean {
  if (!/"botgarten"\s*:\s*"card"/.test(text)) return false
  try {
    return isCardFile(JSON.parse(text))
  } catch {
    return false
  }
}

/** What a home file holds; null for every other text. */
function homeIn(text: string): unknown {
  try {
    const data: unknown = text.includes('"botgartenHome"') ? JSON.parse(text) : null
    return isHome(data) ? data : null
  } catch {
    return null
  }
}

async function takeHomeFile(data: unknown): Promise<OpenedFile> {
  const { projects, bin, settings, broken } = readHome(data)
  await moveOldSorting()
  const here = await listWhole()
  const unread = here.damaged.map(({ id }) => id)
  const { added, copies, same } = mergeHome(here.projects, unread, projects, {
    fresh: freshId,
    copy: (project) => nameOfCopy(shownName({ project }), []),
    place: placeOf,
  })
  const thrown = mergeBin((await listBin()).thrown, bin, Date.now())
  const error = (await add(added)) ?? (await addToBin(thrown))
  if (error) return { problem: 'notKept', facts: {} }
  const come = takeSettings(settings)
  if (!come) return { problem: 'notKept', facts: {} }
  await moveOldSorting()
  return { merged: { added: added.length, copies, same, binned: thrown.length, broken, settings: come } }
}

/** Takes over what is not set here yet; null where the device has no room for it. */
function takeSettings(settings: HomeSettings): Merged['settings'] | null {
  try {
    const merged = mergeSettings(deviceDrawer, settings)
    follow(merged, settings)
    return { taken: merged.taken.some((name) => name !== 'sorting'), kept: merged.kept.length > 0 }
  } catch (cause) {
    storageErrorOf(cause)
    return null
  }
}

/** Puts a foreign project beside those that are here. */
export async function keepProject(project: Project): Promise<OpenedFile> {
  const id = freshId(placeOf(project))
  const saved = await save(id, project, 0)
  if (saved.kind === 'saved') return { id, project }
  if (saved.kind === 'tooMuch') return { problem: 'tooMuch', facts: {} }
  return { problem: 'notKept', facts: {} }
}

/** A file to take home. */
export interface HomeFile {
  readonly name: string
  readonly save: () => void
}

/** Everything that lies on this device as files: one, or as many as it takes. None where there is nothing. */
export async function homeFiles(day = new Date()): Promise<readonly HomeFile[]> {
  await moveOldSorting()
  const [{ projects }, { thrown }, settings] = [await listWhole(), await listBin(), settingsIn(deviceDrawer)]
  if (projects.length + thrown.length === 0 && !settings.sorting) return []
  const texts = packHome(projects, thrown, settings)
  // The page of projects has these words; a sheet on another page does not.
  await fetchWords('files')
  const name = `${m['projects.homeFile']()} ${day.toISOString().slice(0, 10)}`
  return texts.map((text, at) => {
    const own = texts.length === 1 ? name : `${name} ${at + 1}-${texts.length}`
    return { name: own, save: () => handOut(own, text) }
  })
}
