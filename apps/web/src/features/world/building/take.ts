import { inScene, parseScene, ProjectError } from '@botgarten/programs'
import type { Builder } from './builder.svelte.ts'
import { floorPictureFrom } from './picture.ts'

/** Takes a file that was chosen or dropped: a scene, or else a picture for the floor. What is refused changes nothing. */
export async function takeFile(builder: Builder, file: File): Promise<void> {
  if (/\.json$/i.test(file.name) || file.type === 'application/json') await takeScene(builder, file)
  else await takePicture(builder, file)
}

async function takePicture(builder: Builder, file: File): Promise<void> {
  const { session, ui } = builder.mode
  const taken = await floorPictureFrom(file, session.project)
  if ('problem' in taken) {
    ui.announce(`problem.${taken.problem}.title`, `problem.${taken.problem}.text`, taken.facts)
    return
  }
  builder.floors.keep(taken.asset, taken.picture)
  builder.commit({ ...session.lab.document.world, floor: { asset: taken.asset } }, taken.assets)
}

async function takeScene(builder: Builder, file: File): Promise<void> {
  const { session, ui } = builder.mode
  try {
    if (file.size > 5_000_000) throw new ProjectError('tooBig', 'A scene has at most 5 MB.')
    const { assets, ...scene } = parseScene(await file.text())
    const readable = await builder.floors.load(scene, assets)
    if (!readable) return ui.announce('problem.pictureBroken.title', 'problem.pictureBroken.text')
    builder.commit(inScene(session.lab.document.world, scene), assets)
    builder.mode.viewport.fitAll()
  } catch (error) {
    if (!(error instanceof ProjectError)) throw error
    console.warn('The scene was refused.', error)
    ui.announce(`problem.${error.reason}.title`, `problem.${error.reason}.text`, error.facts)
  }
}
