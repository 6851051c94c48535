import { readFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'
import { expect, test, vi } from 'vitest'
import { stageOf } from '#figures/map/testing/stage.ts'
import { drawMap } from './map.ts'

// Only a browser can draw the picture of a map: this one records which stations it shows without fog.
let clear: readonly boolean[] = []
vi.mock('#figures/map/stage.ts', () => ({
  loadStage: (id: string) => {
    const picture = {
      stations: null,
      dress: () => {},
      cover: (all: readonly boolean[]) => void (clear = all),
    }
    const stage = stageOf(id, readFileSync(content.path('maps', id, 'map.svg'), 'utf8'))
    return Promise.resolve({ ...stage, picture })
  },
}))

test('a map on paper has no fog over its stations, although none was visited', async () => {
  const { stage, found } = await drawMap('railway')
  expect(found).toBeNull()
  expect(clear).toHaveLength(stage.map.stations.length)
  expect(clear).not.toContain(false)
})
