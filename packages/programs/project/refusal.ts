import * as v from 'valibot'
import type { Program, Project } from '../types.ts'
import { ProjectError } from './error.ts'
import { issueError } from './issue.ts'
import { bytesIn, mostBytes, mostParts, refuseOversize, tooBig } from './limits.ts'
import { projectSchema } from './schema.ts'

// The same limits on the side that writes: what this lets through, `parseProject` reads.

interface Size {
  readonly bytes: number
  readonly parts: number
}

/** Pictures and programs that have passed. They are frozen data: what has passed once passes again. */
const known = new WeakMap<object, Size>()
const noProgram: Program = { stacks: [], config: { stacks: [] } }
const noPicture: Project['assets'][string] = { type: 'image/png', base64: '' }

/** Why a project must not be written, since reading would refuse it; null where it may. */
export function refusalOf(project: Project): ProjectError | null {
  try {
    refuse(project)
    return null
  } catch (error) {
    if (error instanceof ProjectError) return error
    throw error
  }
}

function refuse(project: Project): void {
  const { programs, assets } = project
  const news = {
    ...project,
    programs: mapped(programs, (program) => (known.has(program) ? noProgram : program)),
    assets: mapped(assets, (asset) => (known.has(asset) ? noPicture : asset)),
  }
  // Before anything that goes into its depth by recursion.
  let parts = refuseOversize(news)
  const result = v.safeParse(projectSchema, news, { abortEarly: true })
  if (!result.success) throw issueError(result.issues[0], news)
  // A digit stands in place of each program and picture.
  let bytes = bytesIn(
    JSON.stringify({ ...project, programs: mapped(programs, () => 0), assets: mapped(assets, () => 0) }),
  )
  for (const part of [...Object.values(programs), ...Object.values(assets)]) {
    const before = known.get(part)
    const size = before ?? sizeOf(part)
    known.set(part, size)
    bytes += size.bytes - 1
    parts += before ? size.parts - 1 : 0
  }
  if (bytes > mostBytes || parts > mostParts) throw tooBig()
}

const sizeOf = (part: unknown): Size => ({
  bytes: bytesIn(JSON.stringify(part)),
  parts: refuseOversize(part),
})

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))

const besideBase64 = JSON.stringify(noPicture).length

/** Programs and pictures of a project that was read have passed. */
export function knowParts({ programs, assets }: Project): void {
  for (const program of Object.values(programs)) known.set(program, sizeOf(program))
  for (const asset of Object.values(assets))
    known.set(asset, { bytes: asset.base64.length + besideBase64, parts: 3 })
}
