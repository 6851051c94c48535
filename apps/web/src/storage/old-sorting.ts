import { sortingProject } from '#content/new-project.ts'
import { shownName } from '#content/names.ts'
import { nameOfCopy } from './messages.ts'
import { freshId, open, save } from './projects.ts'
import { placeOfSetting, readSetting } from './settings.ts'

type Sorting = { readonly [part: string]: unknown }

/** The page of sorting saved its work as a setting until November 2026. Null if there is none. */
export const oldSorting = (): Sorting | null => readSetting<Sorting | null>('sorting', null)

let moving: Promise<void> | null = null

/** Makes a project of it. The setting stays until the project has been read back from the device. */
export function moveOldSorting(): Promise<void> {
  moving ??= move().finally(() => (moving = null))
  return moving
}

async function move(): Promise<void> {
  const old = oldSorting()
  if (!old) return
  const [project, here] = await Promise.all([sortingProject(old), open('sorting')])
  const isHere = async (id: string) => isAlike((await open(id))?.project.sorting, old)
  if (!isAlike(here?.project.sorting, old)) {
    const id = here ? freshId('sorting') : 'sorting'
    const name = here ? nameOfCopy(shownName({ project }), []) : project.name
    await save(id, { ...project, name }, 0)
    if (!(await isHere(id))) return
  }
  localStorage.removeItem(placeOfSetting('sorting'))
}

const isAlike = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b)
