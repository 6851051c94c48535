import { readFileSync } from 'node:fs'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { listFiles } from './tree.mjs'

/**
 * Files with browser tests, each with the rooms that its first line names (`// Rooms: sorting, storage`): features, other
 * folders of the web app, packages, `content`.
 * @returns {{ file: string, rooms: string[] }[]}
 */
export const listSpecs = () =>
  listFiles('e2e/tests', '.spec.ts', '.touch.ts').map((file) => {
    const [, rooms = ''] = /^\/\/ Rooms: (.+)/.exec(readFileSync(inRepo(file), 'utf8')) ?? []
    return { file, rooms: rooms.split(', ').filter(Boolean) }
  })

/** @param {readonly string[]} rooms all where it is empty */
export const specsOf = (rooms, specs = listSpecs()) =>
  specs
    .filter((spec) => rooms.length === 0 || spec.rooms.some((room) => rooms.includes(room)))
    .map(({ file }) => file)
