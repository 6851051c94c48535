import * as v from 'valibot'
import type { SceneFile } from './scene.ts'
import { assetsSchema } from './schema-assets.ts'
import { idsUnique, poseSchema, sceneEntries } from './schema-world.ts'

const starts = v.pipe(v.array(poseSchema), v.maxLength(100))

const hasItsPicture = ({ floor, assets }: SceneFile) =>
  !('asset' in floor) || floor.asset.startsWith('content:') || Object.hasOwn(assets, floor.asset)

/** What is not named here is left out. */
export const sceneFileSchema: v.GenericSchema<unknown, SceneFile> = v.pipe(
  v.object({ botgartenScene: v.literal(1), ...sceneEntries, starts, assets: assetsSchema }),
  v.transform(({ botgartenScene: _, ...scene }): SceneFile => scene),
  v.check((scene) => idsUnique(scene), 'Two things have the same id.'),
  v.check((scene) => hasItsPicture(scene), 'The picture of the floor is missing.'),
)
