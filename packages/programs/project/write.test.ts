import { expect, it } from 'vitest'
import root from '../../../package.json' with { type: 'json' }
import { parseProject, refusalOf, writeProject, writeProjectFile, type Project } from '../index.ts'
import { project } from '../testing/every-part.ts'
import { mostBytes } from './limits.ts'

it('a project file says which version wrote it', () => {
  expect(JSON.parse(writeProjectFile(project))).toEqual({ ...project, madeWith: root.version })
  expect(writeProjectFile(project)).toMatch(/^\{"botgarten":1,"madeWith":"\d+\.\d+\.\d+",/)
})

it('that is of the file alone: the project read from it is the one that was written', () => {
  expect(writeProject(parseProject(writeProjectFile(project)))).toBe(writeProject(parseProject(project)))
})

it('a project that has no room for it is written without, so that it can be read again', () => {
  const filled = (letters: number): Project => ({
    ...project,
    assets: { ['0'.repeat(64)]: { type: 'image/png', base64: 'A'.repeat(letters) } },
  })
  const empty = writeProject(filled(0)).length
  const full = filled(4 * Math.floor((mostBytes - empty) / 4))
  expect(refusalOf(full)).toBeNull()
  expect(writeProjectFile(full)).toBe(writeProject(full))
  expect(parseProject(writeProjectFile(full))).toEqual(full)
})
