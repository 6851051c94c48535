import { learningIn, parseProject, ProjectError, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import { item, looked } from '#figures/gallery/item.ts'
import { askAs, read, type Ask } from '#storage/ask.ts'

/** A project that a pupil has shared with the class. */
interface Shared {
  readonly id: string
  readonly title: string
  /** The pupil's name in the class. */
  readonly by: string
  readonly project: Project
}

const page = v.object({ items: v.array(item) })

/**
 * What a class has shared, as its teacher may see it: a page of its gallery, most hearts first. What learns on a map has
 * no brain for a floor, and is left out. Null: it cannot be had.
 */
export async function sharedIn(school: string, ask: Ask = askAs(null)): Promise<readonly Shared[] | null> {
  const path = `/classes/${encodeURIComponent(school)}/gallery`
  const found = read(page, await ask('GET', `${path}?by=hearts`))
  if (!found) return null
  const all = await Promise.all(found.items.map(({ id }) => sharedOne(ask, `${path}/${id}`)))
  return all.filter((one) => one !== null)
}

async function sharedOne(ask: Ask, path: string): Promise<Shared | null> {
  const found = read(looked, await ask('GET', path))
  if (!found) return null
  const { id, title, by } = found
  try {
    const project = parseProject(found.project)
    const learns = Object.values(project.programs).some((program) => learningIn(program))
    return learns ? null : { id, title, by, project }
  } catch (cause) {
    if (!(cause instanceof ProjectError)) throw cause
    console.warn('Something shared cannot be read.', cause)
    return null
  }
}
