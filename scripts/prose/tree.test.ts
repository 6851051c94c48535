import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, describe, expect, it } from 'vitest'
import { lastTexts, linesOf, proseFiles } from './tree.ts'

let folder: string

const git = (...args: string[]) =>
  execFileSync('git', ['-c', 'user.name=Test', '-c', 'user.email=test@example.org', ...args], { cwd: folder })

const commit = (text: string) => {
  writeFileSync(join(folder, 'a.ts'), text)
  git('add', 'a.ts')
  git('commit', '--quiet', '--message', 'test')
}

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'prose-'))
  git('init', '--quiet')
  commit('// First.')
  commit('// Second.')
})

afterEach(() => rmSync(folder, { recursive: true }))

describe('the last text of a deleted file', () => {
  it('is the committed one if the deletion is not committed yet', () => {
    rmSync(join(folder, 'a.ts'))
    expect(lastTexts(['a.ts'], folder)).toEqual(new Map([['a.ts', '// Second.']]))
  })

  it('is the one before the commit that deleted the file', () => {
    git('rm', '--quiet', 'a.ts')
    git('commit', '--quiet', '--message', 'test')
    expect(lastTexts(['a.ts'], folder)).toEqual(new Map([['a.ts', '// Second.']]))
  })

  it('is unknown for a file that was never committed', () => {
    expect(lastTexts(['b.ts'], folder)).toEqual(new Map())
  })
})

describe('files with prose', () => {
  it('are code and documents, but not texts for children or generated files', () => {
    const files = proseFiles()
    expect(files).toEqual(
      expect.arrayContaining(['README.md', 'scripts/prose/tree.ts', 'apps/web/src/app.css']),
    )
    expect(files.filter((path) => path.startsWith('content/') || path.includes('/generated/'))).toEqual([])
  })

  it('are compared by the lines of their prose, without indentation', () => {
    expect(linesOf('a.ts', '/**\n * First.\n */\nlet a // Second.')).toEqual(['First.', 'Second.'])
  })
})
