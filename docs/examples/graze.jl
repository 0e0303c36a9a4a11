# Graze from Julia, on the C interface. Untested: no Julia was at hand when this was written.
#   include("graze.jl")
#   run = graze(read("scene.toml", String), "simulate", "--periods", "20")
#   run.tables["events"]["time"]
struct GrazeResult
    json::String
    message::String
    tables::Dict{String,Dict{String,Vector}}
end

const libgraze = "libgraze.so.0"

function graze(scene::String, words::String...)
    run = ccall((:graze_run, libgraze), Ptr{Cvoid}, (Cstring, Ptr{Cstring}, Csize_t),
                scene, collect(words), length(words))
    try
        message = unsafe_string(ccall((:graze_message, libgraze), Cstring, (Ptr{Cvoid},), run))
        status = ccall((:graze_status, libgraze), Cint, (Ptr{Cvoid},), run)
        status in (2, 4) && error(message)
        json = unsafe_string(ccall((:graze_json, libgraze), Cstring, (Ptr{Cvoid},), run))
        tables = Dict{String,Dict{String,Vector}}()
        for i in Iterators.countfrom(0)
            name = ccall((:graze_table_name, libgraze), Cstring, (Ptr{Cvoid}, Csize_t), run, i)
            name == C_NULL && break
            tables[unsafe_string(name)] = graze_table(run, unsafe_string(name))
        end
        return GrazeResult(json, message, tables)
    finally
        ccall((:graze_free, libgraze), Cvoid, (Ptr{Cvoid},), run)
    end
end

function graze_table(run, table::String)
    columns = Dict{String,Vector}()
    for i in Iterators.countfrom(0)
        name = ccall((:graze_column_name, libgraze), Cstring, (Ptr{Cvoid}, Cstring, Csize_t), run, table, i)
        name == C_NULL && break
        column = unsafe_string(name)
        count, stride = Ref{Csize_t}(0), Ref{Csize_t}(0)
        data = ccall((:graze_column, libgraze), Ptr{Cdouble},
                     (Ptr{Cvoid}, Cstring, Cstring, Ptr{Csize_t}, Ptr{Csize_t}),
                     run, table, column, count, stride)
        numbers = [unsafe_load(data, 1 + k * stride[]) for k in 0:Int(count[])-1]
        columns[column] = graze_words(run, table, column, numbers)
    end
    return columns
end

# The words of a column of words, else the numbers as they are.
function graze_words(run, table, column, numbers)
    word(k) = ccall((:graze_word, libgraze), Cstring, (Ptr{Cvoid}, Cstring, Cstring, Csize_t),
                    run, table, column, k)
    word(0) == C_NULL && return numbers
    return [isnan(x) ? "" : unsafe_string(word(Int(x))) for x in numbers]
end
