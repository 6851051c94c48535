import type { Template } from '../types.ts'

/** A truth, for examples. */
export const truth = (value: boolean): Template => ({
  type: 'logic_boolean',
  fields: { BOOL: value ? 'TRUE' : 'FALSE' },
})
