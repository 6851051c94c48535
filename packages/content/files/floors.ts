import { readFileSync } from 'node:fs'
import type { Project } from '@botgarten/programs'
import { paintFloor, type Floor, type World } from '@botgarten/simulation'
import { readPng } from '@botgarten/simulation/png'
import type { Folder } from './folder.ts'

/** So many floors are kept, of several MB each: the runs of one card share theirs. */
const most = 4

/** Floors of worlds whose picture is in content/ or among a project's assets. Nobody paints on a floor that is handed out. */
export function floorsIn(content: Folder): (world: World, assets?: Project['assets']) => Floor {
  const kept = new Map<string, Floor>()

  function ofProduct(world: World): Floor {
    const { size, floor, areas, lines } = world
    const key = JSON.stringify([size, floor, areas, lines])
    const painted = kept.get(key) ?? paintFloor(world, pictureOf(floor))
    kept.delete(key)
    kept.set(key, painted)
    if (kept.size > most) kept.delete(kept.keys().next().value!)
    return painted
  }

  function pictureOf(floor: World['floor']) {
    // Only names that the product ships: a project file must not read other files of this machine.
    const file = 'asset' in floor ? shipped(floor.asset) : undefined
    return file === undefined ? undefined : readPng(readFileSync(content.path(file)))
  }

  return (world, assets = {}) => {
    const asset = 'asset' in world.floor ? world.floor.asset : ''
    if (shipped(asset) !== undefined || !Object.hasOwn(assets, asset)) return ofProduct(world)
    return paintFloor(world, readPng(Buffer.from(assets[asset]!.base64, 'base64')))
  }
}

const shipped = (asset: string) => /^content:(worlds\/[a-z0-9-]+\/floor\.png)$/.exec(asset)?.[1]
