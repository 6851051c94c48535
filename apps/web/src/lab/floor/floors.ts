import { pictureIn } from './pictures.ts'
import type { Project, Scene } from '@botgarten/programs'
import { paintFloor, type Floor, type Picture, type World } from '@botgarten/simulation'

/** Pictures of floors, unpacked once, so that a floor is painted within a frame. */
export class Floors {
  #pictures = new Map<string, Picture>()

  keep(asset: string, picture: Picture): void {
    this.#pictures.set(asset, picture)
  }

  /** Fetches and unpacks the picture of a scene's floor. What cannot be read is white; returns whether it could. */
  async load(scene: Pick<World, 'floor'>, assets: Project['assets']): Promise<boolean> {
    const { floor } = scene
    if (!('asset' in floor) || this.#pictures.has(floor.asset)) return true
    try {
      const picture = await pictureIn(scene, assets[floor.asset])
      if (picture) this.#pictures.set(floor.asset, picture)
      return picture !== null
    } catch (cause) {
      console.warn('The picture of the floor cannot be read.', cause)
      return false
    }
  }

  paint = (scene: Pick<Scene, 'size' | 'floor' | 'areas' | 'lines'>): Floor => {
    const picture = 'asset' in scene.floor ? this.#pictures.get(scene.floor.asset) : undefined
    return paintFloor(scene, picture)
  }
}
