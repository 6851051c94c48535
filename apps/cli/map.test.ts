import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { addRoad, addStation, emptyMap, writeMap } from '@botgarten/maps/own'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { describe, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const path = join(mkdtempSync(join(tmpdir(), 'botgarten-')), 'mine.svg')
const fits = (name: string) =>
  new Ajv2020().compile(
    JSON.parse(readFileSync(join(import.meta.dirname, `schemas/${name}.json`), 'utf8')) as object,
  )
const two = [{ x: 200, y: 200 }, { x: 500, y: 200 }].reduce(addStation, emptyMap('mine')) // prettier-ignore

describe('botgarten map', () => {
  it('check says that a drawing is sound, with its stations and moves', async () => {
    writeFileSync(path, writeMap(addRoad(two, 0, 1), 'mine'))
    const { status, json } = await botgarten('map', 'check', path, '--json')
    expect(status).toBe(0)
    const fitting = fits('map-check')
    fitting(json())
    expect(fitting.errors).toBeNull()
    expect(json()).toEqual({ ok: true, stations: 2, roads: 2, problems: [], warnings: [] })
  })

  it('check names every broken rule, and ends with 1', async () => {
    const text = writeMap(addRoad(two, 0, 1), 'mine').replace('id="path-1-0"', 'id="path-3-9"')
    writeFileSync(path, text)
    const { status, stderr } = await botgarten('map', 'check', path, '--lang', 'en')
    expect(status).toBe(1)
    expect(stderr).toContain('path-3-9 leads to a station 3 that is not there')
  })

  it('drive tries each road in both directions', async () => {
    writeFileSync(path, writeMap(addRoad(two, 0, 1), 'mine'))
    const { status, json } = await botgarten('map', 'drive', path, '--json')
    expect(status).toBe(0)
    const fitting = fits('map-drive')
    fitting(json())
    expect(fitting.errors).toBeNull()
    expect(json()).toMatchObject({ driven: 2, of: 2 })
  })
})
