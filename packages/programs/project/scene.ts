import * as v from 'valibot'
import type { Project } from '../types.ts'
import { ProjectError } from './error.ts'
import { most, refuseBigText, refuseOversize } from './limits.ts'
import { looksForeign, readForeignScene } from './scene-open-roberta.ts'
import type { Scene } from './scene-world.ts'
import { sceneFileSchema } from './schema-scene.ts'

/** A scene with the picture of its floor, if it has one of its own. */
export interface SceneFile extends Scene {
  readonly assets: Project['assets']
}

/** One line of JSON. What `parseScene` made comes back from it the same. */
export function writeScene(scene: Scene, pictures: Project['assets']): string {
  const { floor } = scene
  const own = 'asset' in floor && Object.hasOwn(pictures, floor.asset) ? floor.asset : null
  return JSON.stringify({ botgartenScene: 1, ...scene, assets: own ? { [own]: pictures[own] } : {} })
}

/**
 * A scene from a file's text: ours, or one that Open Roberta has saved. Nothing of it is trusted.
 * @throws {ProjectError} and nothing else
 */
export function parseScene(text: string): SceneFile {
  const data = dataIn(text)
  refuseOversize(data)
  refuseOther(data)
  refuseCrowd(data)
  const result = v.safeParse(sceneFileSchema, looksForeign(data) ? readForeignScene(data) : data, {
    abortEarly: true,
  })
  if (result.success) return result.output
  const { path, message } = result.issues[0]
  throw new ProjectError('notAScene', `${path?.map(({ key }) => String(key)).join('.') ?? ''}: ${message}`)
}

function dataIn(text: string): unknown {
  refuseBigText(text)
  try {
    return JSON.parse(text)
  } catch {
    throw new ProjectError('sceneNotJson', 'This is not JSON.')
  }
}

function refuseOther(data: unknown): void {
  const { botgarten, botgartenScene: version } = { ...(data as { [name: string]: unknown }) }
  if (botgarten !== undefined) throw new ProjectError('isAProject', 'This is a project, not a scene.')
  if (typeof version !== 'number' || !(version > 1)) return
  throw new ProjectError('newerVersion', `The scene has version ${version}; this Botgarten reads 1.`, {
    version,
  })
}

/** Counted before anything else is looked at: too many things get an answer of their own. */
function refuseCrowd(data: unknown): void {
  const lists = { ...(data as { [name: string]: unknown }) }
  const sizeOf = (name: string) => (Array.isArray(lists[name]) ? lists[name].length : 0)
  // A marker of Open Roberta's is an area with two lines on it.
  const counts = [
    ['obstacles', sizeOf('obstacles'), most.obstacles],
    ['areas', sizeOf('areas'), most.areas],
    ['markers', sizeOf('marker'), most.lines / 2],
    ['colour areas', sizeOf('colorAreas') + sizeOf('marker'), most.areas],
    ['lines', sizeOf('lines'), most.lines],
  ] as const
  for (const [name, count, limit] of counts) {
    if (count <= limit) continue
    const message = `The scene has ${count} ${name}; a world holds at most ${limit}.`
    throw new ProjectError('tooManyThings', message, { count, most: limit })
  }
}
