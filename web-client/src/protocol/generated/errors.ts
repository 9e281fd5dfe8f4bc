// Made by protocol/api/generate from errors.schema.json: do not edit.

/** Codes of errors, by kind. */
export const errorCodes = {
    parseError: -32700,
    invalidRequest: -32600,
    methodNotFound: -32601,
    invalidParameters: -32602,
    internal: -32603,
    cancelled: -32800,
    stale: -32801,
    unauthenticated: -32001,
    notPermitted: -32003,
    notFound: -32004,
    leased: -32011,
    outsideDomain: -32012,
    outsideTimeRange: -32013,
    overLimit: -32014,
    datasetError: -32015,
} as const;
