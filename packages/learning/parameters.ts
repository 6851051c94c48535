/** Parameters as JSON Schema (2020-12), as much of it as learners need. */
export interface ObjectSchema {
  readonly type: 'object'
  readonly properties: { readonly [name: string]: ParameterSchema }
  readonly required: readonly string[]
  readonly additionalProperties: false
}

export type ParameterSchema =
  | { readonly type: 'number' | 'integer'; readonly minimum: number; readonly maximum?: number }
  | { readonly enum: readonly string[] }
  /** Told apart by their property `kind`. */
  | { readonly oneOf: readonly ObjectSchema[] }

/** @throws RangeError that names the first parameter outside the schema */
export function refuseOutside(schema: ObjectSchema, parameters: object, path = ''): void {
  const given = Object.entries(parameters).filter(([, value]) => value !== undefined)
  for (const name of schema.required)
    if (!given.some(([key]) => key === name)) throw new RangeError(`${path}${name} is missing.`)
  for (const [name, value] of given) {
    const own = Object.hasOwn(schema.properties, name) ? schema.properties[name] : undefined
    if (!own) throw new RangeError(`There is no parameter ${path}${name}.`)
    refuseValue(own, value, path + name)
  }
}

function refuseValue(schema: ParameterSchema, value: unknown, name: string): void {
  if ('oneOf' in schema) refuseKind(schema.oneOf, value, name)
  else if ('enum' in schema) refuseOther(schema.enum, value, name)
  else {
    const { type, minimum, maximum = Infinity } = schema
    const counts = type === 'integer' ? Number.isInteger(value) : Number.isFinite(value)
    if (counts && (value as number) >= minimum && (value as number) <= maximum) return
    const what = type === 'integer' ? 'a whole number' : 'a number'
    const range = maximum === Infinity ? `of at least ${minimum}` : `from ${minimum} to ${maximum}`
    throw new RangeError(`${name} is ${String(value)}; it must be ${what} ${range}.`)
  }
}

function refuseOther(values: readonly string[], value: unknown, name: string): void {
  if (!values.includes(value as string))
    throw new RangeError(`${name} is ${String(value)}; it must be one of ${values.join(', ')}.`)
}

function refuseKind(schemas: readonly ObjectSchema[], value: unknown, name: string): void {
  if (typeof value !== 'object' || value === null) throw new RangeError(`${name} is no object.`)
  const kind = (value as { readonly kind?: unknown }).kind
  const kindsOf = ({ properties: { kind: own } }: ObjectSchema) => (own && 'enum' in own ? own.enum : [])
  refuseOther(schemas.flatMap(kindsOf), kind, `${name}.kind`)
  refuseOutside(
    schemas.find((schema) => kindsOf(schema).includes(kind as string))!,
    value,
    `${name}.`,
  )
}
